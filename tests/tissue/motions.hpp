#pragma once

#include <Eigen/Geometry>

#include "tissue/symmetric_tensor.hpp"

namespace springcheck::tissue {

inline SymmetricTensor right_cauchy_green(const Eigen::Matrix3d& F) {
  return symmetric_tensor(F.transpose() * F);
}

inline Eigen::Matrix3d rotation(const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

}  // namespace springcheck::tissue
