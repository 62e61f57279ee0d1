#pragma once

#include <Eigen/SparseCore>

#include "mss/forces/tangent.hpp"
#include "statics/systems/free_triangle.hpp"

namespace springcheck::mss {

/// The lower triangle of a tangent over the free components.
inline Eigen::SparseMatrix<double> lower_triangle(const Network& network,
                                                  const Tangent& tangent,
                                                  const std::vector<bool>& is_free) {
  const statics::Unknowns unknowns(is_free);
  statics::BlockMatrix matrix(patches(network), network.masses.size());
  matrix.assemble([&](std::size_t patch) { return part(tangent, patch); });
  return statics::FreeTriangle(matrix, unknowns).copy_of(matrix);
}

}  // namespace springcheck::mss
