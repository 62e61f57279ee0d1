#pragma once

#include "statics/systems/row_matrix.hpp"

namespace springcheck::statics {

/// A smoother: the polynomial of third degree in D^-1 A, D the diagonal of A, that is
/// smallest from a thirtieth of a bound of the spectrum on. Symmetric, and positive
/// definite where A is. The bound, max over rows of sum |A_ij|/A_ii, is two to three
/// times the largest eigenvalue of matrices of elasticity. An estimate below that
/// eigenvalue could leave the smoother indefinite: ten steps of the power method were too
/// few for 16^3 cells of q2. Source: Adams, Brezina, Hu and Tuminaro, J. Comput. Phys.
/// 188 (2003) 593; Saad, Iterative Methods for Sparse Linear Systems (2003),
/// algorithm 12.1.
class Chebyshev {
 public:
  explicit Chebyshev(const RowMatrix& matrix);

  /// Returns about A^-1 right; `matrix` is the A that the smoother was made of.
  [[nodiscard]] Eigen::VectorXd from_zero(const RowMatrix& matrix,
                                          const Eigen::VectorXd& right) const;

 private:
  Eigen::VectorXd inverse_diagonal_;
  double bound_;  // of the eigenvalues of D^-1 A
};

}  // namespace springcheck::statics
