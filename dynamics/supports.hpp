#pragma once

#include <vector>

#include "meshing/loads/scene.hpp"

namespace springcheck::dynamics {

/// A displacement affine in the material point, u = gradient X + shift.
struct AffineDisplacement {
  Eigen::Matrix3d gradient;
  Vector3 shift;  // [m]

  [[nodiscard]] double component(const Vector3& point, int i) const {
    return gradient.row(i).dot(point) + shift[i];
  }
  [[nodiscard]] bool is_equal_everywhere(int i) const {
    return gradient(i, 0) == 0 && gradient(i, 1) == 0 && gradient(i, 2) == 0;
  }
};

/// A component of a node that moves as the scene prescribes.
struct Support {
  NodeIndex node;
  std::uint8_t component;
  std::uint32_t motion;  // in support_motions
};
std::vector<Support> supports(const Scene& scene,
                              const std::vector<PrescribedComponent>& prescribed);

/// The motions at a load fraction: those of the scene's plates in turn, then that of the
/// other supports, the boundary's gradient or rest.
std::vector<AffineDisplacement> support_motions(const Scene& scene, double load_fraction);

}  // namespace springcheck::dynamics
