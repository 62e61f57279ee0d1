#pragma once

#include "fem_reference/cells/cell.hpp"

namespace springcheck::fem_reference {

/// Adds B^T A B, B the map from nodal displacements to H, whose gradients are g; A is
/// symmetric.
template <class Gradients>
void add_stiffness(CellMatrix& K, const Matrix9& A, const Gradients& g) {
  // Column (i + 3J) of `changes` is the change of P_iJ by each dof.
  Eigen::MatrixXd changes(3 * g.cols(), 9);
  for (Eigen::Index c = 0; c < 9; ++c)
    changes.col(c).reshaped(3, g.cols()) =
        A.col(c).reshaped(3, 3).lazyProduct(g);  // too small for a blocked product
  for (Eigen::Index a = 0; a < g.cols(); ++a)
    for (Eigen::Index i = 0; i < 3; ++i)
      K.col(3 * a + i) += g(0, a) * changes.col(i) + g(1, a) * changes.col(i + 3) +
                          g(2, a) * changes.col(i + 6);
}

/// H = F - I at a Gauss point; behind the last, its mean over the cell.
inline Matrix3 displacement_gradient(const Shape& shape, const CellVectors& u,
                                     Eigen::Index point) {
  return u * shape.gradients_at(point).transpose();
}

}  // namespace springcheck::fem_reference
