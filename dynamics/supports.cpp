#include "dynamics/supports.hpp"

namespace springcheck::dynamics {

std::vector<Support> supports(const Scene& scene,
                              const std::vector<PrescribedComponent>& prescribed) {
  std::vector<Support> list;
  for (const auto& [node, component, plate] : prescribed)
    list.push_back(
        {.node = node,
         .component = component,
         .motion = static_cast<std::uint32_t>(plate.value_or(scene.plates.size()))});
  return list;
}

std::vector<AffineDisplacement> support_motions(const Scene& scene,
                                                double load_fraction) {
  std::vector<AffineDisplacement> motions;
  for (const Plate& plate : scene.plates) {
    const Vector3 shift = displacement(plate.motion, Vector3::Zero(), load_fraction);
    Eigen::Matrix3d gradient;
    for (int j = 0; j < 3; ++j)
      gradient.col(j) =
          displacement(plate.motion, Vector3::Unit(j), load_fraction) - shift;
    motions.push_back({gradient, shift});
  }
  motions.push_back(
      {load_fraction * scene.boundary_gradient.value_or(Eigen::Matrix3d::Zero()),
       Vector3::Zero()});
  return motions;
}

}  // namespace springcheck::dynamics
