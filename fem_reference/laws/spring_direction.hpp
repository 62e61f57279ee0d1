#pragma once

#include <Eigen/Core>

namespace springcheck::fem_reference {

/// A direction of a lattice's springs: all springs of stiffness k and rest length l along
/// n, one in each volume V, weigh w = k l^2/V.
struct SpringDirection {
  Eigen::Vector3d direction;  // n, a unit vector
  double weight;              // w [Pa]
};

}  // namespace springcheck::fem_reference
