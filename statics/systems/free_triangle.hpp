#pragma once

#include <Eigen/SparseCore>

#include "statics/systems/block_matrix.hpp"
#include "statics/systems/unknowns.hpp"

namespace springcheck::statics {

/// The diagonal's entries of the unknowns.
Eigen::VectorXd diagonal(const BlockMatrix& matrix, const Unknowns& unknowns);

/// Copies of a block matrix's entries of the unknowns: the lower triangle as a sparse
/// matrix, its pattern laid out once.
class FreeTriangle {
 public:
  /// Refers to the unknowns. Throws std::length_error beyond 2^31 entries.
  FreeTriangle(const BlockMatrix& matrix, const Unknowns& unknowns);

  /// The copy of a matrix of the same blocks.
  [[nodiscard]] const Eigen::SparseMatrix<double>& copy_of(const BlockMatrix& matrix);

 private:
  const Unknowns& unknowns_;
  Eigen::SparseMatrix<double> copy_;
};

}  // namespace springcheck::statics
