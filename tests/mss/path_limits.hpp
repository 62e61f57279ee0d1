#pragma once

#include "mss/statics/network_body.hpp"
#include "statics/path_limit.hpp"

namespace springcheck::mss {

/// statics::follow_to_limit of a network under a scene's loads.
inline statics::PathLimit limit_of(
    const Mesh& mesh, const Scene& scene, const Network& network, double resolution,
    const statics::AcceptState& accept = [](const Eigen::VectorXd&, double) {
      return true;
    }) {
  NetworkBody body(network);
  const statics::Loading drive = loading(mesh, scene, network);
  statics::PotentialEnergy potential(body, drive, statics::LinearSolver::automatic);
  return statics::follow_to_limit(potential, resolution, accept);
}

}  // namespace springcheck::mss
