#pragma once

#include "mss/dynamics.hpp"
#include "mss/network.hpp"

namespace springcheck::mss {

enum class Solver { static_equilibrium, semi_implicit_euler };

struct Settings {
  NetworkSettings network;
  Solver solver;
  DynamicsSettings dynamics;  // read by semi_implicit_euler
  unsigned seed;              // read by static_equilibrium, to leave saddles
};

/// Deforms the body as a mass-spring system. Node numbers are the mesh's. A failed
/// simulation is a Solution with the status that says so.
Solution solve(const Mesh& mesh, const Scene& scene, const Settings& settings);

}  // namespace springcheck::mss
