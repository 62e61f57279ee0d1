#pragma once

#include "mss/motion/dynamics.hpp"
#include "mss/networks/network.hpp"
#include "statics/search.hpp"

namespace springcheck::mss {

struct Settings {
  NetworkSettings network;
  std::optional<DynamicsSettings> dynamics;  // none: static equilibrium
  statics::Search search{};                  // for that
};

/// Deforms the body as a mass-spring system. Node numbers are the mesh's. A failed
/// simulation is a Solution with the status that says so.
Solution solve(const Mesh& mesh, const Scene& scene, const Settings& settings,
               const dynamics::Observers& observers = {});

}  // namespace springcheck::mss
