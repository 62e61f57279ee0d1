#include "meshing/generators/gmsh_session.hpp"

#include <gmsh.h>

namespace springcheck {
namespace {

std::mutex& mutex() {
  static std::mutex the_only_one;
  return the_only_one;
}

}  // namespace

GmshSession::GmshSession(const std::string& model) : lock_(mutex()) {
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
