#pragma once

#include <Eigen/Core>
#include <random>

namespace springcheck {

/// Components uniform in [-1, 1); the same on every platform.
inline Eigen::VectorXd random_vector(Eigen::Index size, std::mt19937_64& random) {
  Eigen::VectorXd v(size);
  for (double& component : v)
    component = 2 * static_cast<double>(random() >> 11U) * 0x1p-53 - 1;
  return v;
}

}  // namespace springcheck
