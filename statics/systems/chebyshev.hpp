#pragma once

#include "statics/systems/row_matrix.hpp"

namespace springcheck::statics {

/// A smoother: the polynomial of third degree in D^-1 A, D the diagonal of A, that is
/// smallest over the upper part of its spectrum, from a fifteenth of the largest eigenvalue
/// on. Symmetric, and positive definite where A is. The largest eigenvalue is an estimate
/// from ten steps of the power method from a fixed start, and a tenth more.
/// Source: Adams, Brezina, Hu and Tuminaro, J. Comput. Phys. 188 (2003) 593; Saad,
/// Iterative Methods for Sparse Linear Systems (2003), algorithm 12.1.
class Chebyshev {
 public:
  explicit Chebyshev(const RowMatrix& matrix);

  /// About A^-1 right, of the A that it was made of.
  [[nodiscard]] Eigen::VectorXd from_zero(const RowMatrix& matrix,
                                          const Eigen::VectorXd& right) const;

 private:
  Eigen::VectorXd inverse_diagonal_;
  double largest_;  // eigenvalue of D^-1 A
};

}  // namespace springcheck::statics
