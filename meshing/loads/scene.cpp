#include "meshing/loads/scene.hpp"

#include <algorithm>

#include "meshing/basics/input_error.hpp"

namespace springcheck {

LameConstants lame_constants(const Material& material) {
  const double E = material.young_modulus, nu = material.poisson_ratio;
  return {.lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), .mu = E / (2 * (1 + nu))};
}

double bulk_modulus(const LameConstants& lame) {
  return lame.lambda + 2 * lame.mu / 3;
}

Vector3 displacement(const RigidMotion& motion, const Vector3& point,
                     double load_fraction) {
  const Eigen::AngleAxisd rotation(load_fraction * motion.angle, motion.axis);
  const Vector3 arm = point - motion.centre;
  return rotation * arm - arm + load_fraction * motion.translation;
}

void add_reason(std::string& reason, const std::string& more) {
  if (more.empty()) return;
  reason += (reason.empty() ? "" : "; ") + more;
}

Solution refused(const std::string& reason) {
  return {.status = SolveStatus::refused,
          .reason = reason,
          .lever_arms = LeverArms::deformed,
          .strain_energy = 0,
          .load_fraction = 0,
          .steps = 0,
          .force_evaluations = 0};
}

namespace {

/// "plate 'top'", "a pin", "the boundary gradient".
std::string holder(const Scene& scene, const PrescribedComponent& prescribed) {
  if (prescribed.plate) return "plate '" + scene.plates[*prescribed.plate].region + "'";
  return scene.boundary_gradient ? "the boundary gradient" : "a pin";
}

NodeIndex nearest_node(const Mesh& mesh, const Vector3& point) {
  const auto nearest = std::ranges::min_element(
      mesh.nodes(), {}, [&](const Vector3& x) { return (x - point).squaredNorm(); });
  return static_cast<NodeIndex>(nearest - mesh.nodes().begin());
}

}  // namespace

std::vector<PrescribedComponent> prescribed_components(const Mesh& mesh,
                                                       const Scene& scene) {
  std::vector<PrescribedComponent> all;
  const auto hold = [&](NodeIndex node, const Held& held,
                        std::optional<std::size_t> plate) {
    for (std::uint8_t i = 0; i < 3; ++i)
      if (held[i]) all.push_back({.node = node, .component = i, .plate = plate});
  };
  for (std::size_t plate = 0; plate < scene.plates.size(); ++plate)
    for (const NodeIndex node : mesh.region(scene.plates[plate].region).nodes)
      hold(node, scene.plates[plate].held, plate);
  for (const auto& [point, held] : scene.pins)
    hold(nearest_node(mesh, point), held, std::nullopt);
  if (scene.boundary_gradient)
    for (const NodeIndex node : mesh.boundary().nodes)
      hold(node, all_components, std::nullopt);

  const auto place = [](const PrescribedComponent& p) {
    return std::pair(p.node, p.component);
  };
  std::ranges::stable_sort(all, {}, place);
  const auto twice = std::ranges::adjacent_find(all, {}, place);
  if (twice != all.end())
    throw InputError(mesh.source(),
                     "node " + std::to_string(twice->node + 1) + ", component " +
                         "xyz"[twice->component],
                     "prescribed at most once",
                     "twice: by " + holder(scene, *twice) + " and " +
                         holder(scene, *std::next(twice)));
  return all;
}

double prescribed_displacement(const Mesh& mesh, const Scene& scene,
                               const PrescribedComponent& prescribed,
                               double load_fraction) {
  const Vector3& point = mesh.nodes()[prescribed.node];
  if (prescribed.plate)
    return displacement(scene.plates[*prescribed.plate].motion, point,
                        load_fraction)[prescribed.component];
  if (scene.boundary_gradient)
    return load_fraction * scene.boundary_gradient->row(prescribed.component).dot(point);
  return 0;
}

std::vector<bool> free_components(const Mesh& mesh,
                                  const std::vector<PrescribedComponent>& prescribed) {
  std::vector<bool> is_free(3 * mesh.nodes().size(), true);
  for (const auto& [node, component, plate] : prescribed)
    is_free[3 * std::size_t{node} + component] = false;
  return is_free;
}

}  // namespace springcheck
