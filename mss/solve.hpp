#pragma once

#include "mss/motion/dynamics.hpp"
#include "mss/networks/network.hpp"

namespace springcheck::mss {

struct Settings {
  NetworkSettings network;
  std::optional<DynamicsSettings> dynamics;  // none: static equilibrium
  bool to_limit;  // of statics: to where the path loses its stability, find_path_limit
  unsigned seed;  // of the static solver, to leave saddles, and of the noise
  double noise;   // [cell edges] of a static solution, see find_equilibrium
};

/// Deforms the body as a mass-spring system. Node numbers are the mesh's. A failed
/// simulation is a Solution with the status that says so.
Solution solve(const Mesh& mesh, const Scene& scene, const Settings& settings,
               const dynamics::Observers& observers = {});

}  // namespace springcheck::mss
