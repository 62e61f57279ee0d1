#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "meshing/basics/vector3.hpp"

namespace springcheck::statics {

/// One vector per node as a vector of all components, 3 node + component.
inline Eigen::VectorXd stacked(std::span<const Vector3> vectors) {
  return Eigen::Map<const Eigen::VectorXd>(vectors.data()->data(),
                                           3 * std::ssize(vectors));
}

/// A vector of all components as one vector per node.
inline std::vector<Vector3> by_node(const Eigen::VectorXd& all) {
  std::vector<Vector3> vectors(static_cast<std::size_t>(all.size() / 3));
  Eigen::Map<Eigen::VectorXd>(vectors.data()->data(), all.size()) = all;
  return vectors;
}

}  // namespace springcheck::statics
