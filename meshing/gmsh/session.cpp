#include "meshing/gmsh/session.hpp"

#include <gmsh.h>

#include "meshing/basics/random_numbers.hpp"

namespace springcheck {

GmshSession::GmshSession(const std::string& model) : lock_(random_numbers()) {
  ::gmsh::initialize(0, nullptr, false);
  ::gmsh::option::setNumber("General.Terminal", 0);
  ::gmsh::option::setNumber("General.NumThreads", 1);
  ::gmsh::option::setNumber("Mesh.RandomSeed", 1);
  ::gmsh::model::add(model);
}

GmshSession::~GmshSession() {
  ::gmsh::finalize();
}

}  // namespace springcheck
