#pragma once

#include "meshing/basics/vector3.hpp"

namespace springcheck::fem_reference {

/// Derivative of a 3x3 matrix with respect to another; entry (i + 3J, k + 3L) is
/// dP_iJ/dF_kL.
using Matrix9 = Eigen::Matrix<double, 9, 9>;

/// A 3x3 matrix as the column of a Matrix9: entry i + 3J.
using Vector9 = Eigen::Matrix<double, 9, 1>;

}  // namespace springcheck::fem_reference
