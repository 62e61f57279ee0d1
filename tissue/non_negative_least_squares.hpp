#pragma once

#include <Eigen/Core>

namespace springcheck::tissue {

/// The x >= 0 that makes |A x - b| least, A having full column rank, to round-off.
/// Source: C. L. Lawson, R. J. Hanson, "Solving Least Squares Problems", 1974, algorithm
/// NNLS of chapter 23. Eigen has none in 3.4.
Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& A,
                                           const Eigen::VectorXd& b);

}  // namespace springcheck::tissue
