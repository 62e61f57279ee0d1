#include "meshing/generators/gmsh.hpp"

#include <gmsh.h>

#include "meshing/generators/gmsh_session.hpp"

namespace springcheck {

std::string gmsh_version() {
  const GmshSession session("version");
  std::string version;
  ::gmsh::option::getString("General.Version", version);
  return version;
}

}  // namespace springcheck
