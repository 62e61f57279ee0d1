#include "meshing/gmsh/version.hpp"

#include <gmsh.h>

#include "meshing/gmsh/session.hpp"

namespace springcheck {

std::string gmsh_version() {
  const GmshSession session("version");
  std::string version;
  ::gmsh::option::getString("General.Version", version);
  return version;
}

}  // namespace springcheck
