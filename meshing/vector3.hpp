#pragma once

#include <Eigen/Geometry>  // Core with cross()

namespace springcheck {

/// A point [m], displacement [m] or force [N].
using Vector3 = Eigen::Vector3d;

}  // namespace springcheck
