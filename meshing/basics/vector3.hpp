#pragma once

#include <Eigen/Geometry>  // Core with cross()

namespace springcheck {

/// A point [m], displacement [m] or force [N].
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

}  // namespace springcheck
