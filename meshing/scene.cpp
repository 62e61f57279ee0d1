#include "meshing/scene.hpp"

#include <algorithm>

#include "meshing/input_error.hpp"

namespace springcheck {

LameConstants lame_constants(const Material& material) {
  const double E = material.young_modulus, nu = material.poisson_ratio;
  return {.lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), .mu = E / (2 * (1 + nu))};
}

Vector3 displacement(const RigidMotion& motion, const Vector3& point,
                     double load_fraction) {
  const Eigen::AngleAxisd rotation(load_fraction * motion.angle, motion.axis);
  const Vector3 arm = point - motion.centre;
  return rotation * arm - arm + load_fraction * motion.translation;
}

Solution refused(const std::string& reason) {
  return {.status = SolveStatus::refused,
          .reason = reason,
          .displacements = {},
          .reactions = {},
          .lever_arms = LeverArms::deformed,
          .strain_energy = 0,
          .load_fraction = 0,
          .steps = 0,
          .force_evaluations = 0};
}

std::vector<PrescribedNode> prescribed_nodes(const Mesh& mesh, const Scene& scene) {
  std::vector<PrescribedNode> prescribed;
  for (std::size_t plate = 0; plate < scene.plates.size(); ++plate)
    for (const NodeIndex node : mesh.region(scene.plates[plate].region).nodes)
      prescribed.push_back({.node = node, .plate = plate});
  std::ranges::sort(prescribed, {}, &PrescribedNode::node);
  const auto twice = std::ranges::adjacent_find(prescribed, {}, &PrescribedNode::node);
  if (twice != prescribed.end())
    throw InputError(mesh.source(), "node " + std::to_string(twice->node),
                     "at most one plate",
                     "two ('" + scene.plates[twice->plate].region + "' and '" +
                         scene.plates[std::next(twice)->plate].region + "')");
  return prescribed;
}

}  // namespace springcheck
