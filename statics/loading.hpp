#pragma once

#include <Eigen/Core>
#include <functional>

#include "meshing/loads/scene.hpp"

namespace springcheck::statics {

/// What drives a body, as the load fraction s goes from 0 to 1. Vectors hold all
/// components, 3 node + component.
struct Loading {
  std::vector<bool> is_free;  // the other components are prescribed
  /// Prescribed displacements at s [m]; entries of free components are not read.
  std::function<Eigen::VectorXd(double)> displacements;
  Eigen::VectorXd forces;  // at s = 1 [N], in proportion to s
  /// Whether displacements found at s belong to where the supports went by then, and not
  /// to another turn of theirs that ends in the same place.
  std::function<bool(const Eigen::VectorXd&, double)> follows_supports;
};

/// The loading of a scene on the mesh's own nodes, with these forces; it refers to both.
Loading loading(const Mesh& mesh, const Scene& scene, Eigen::VectorXd forces);

}  // namespace springcheck::statics
