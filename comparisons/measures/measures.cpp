#include "comparisons/measures/measures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <type_traits>

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/measures/beam_measures.hpp"
#include "comparisons/measures/displacement_norms.hpp"
#include "meshing/cell_geometry.hpp"
#include "meshing/loads/traction.hpp"

namespace springcheck {
namespace {

std::vector<Vector3> deformed(const Mesh& mesh, std::span<const Vector3> displacements) {
  std::vector<Vector3> positions = mesh.nodes();
  for (std::size_t n = 0; n < positions.size(); ++n) positions[n] += displacements[n];
  return positions;
}

void measure_volumes(Measures& measures, const Mesh& mesh, const Solution& solution,
                     std::span<const Vector3> positions) {
  const std::vector<double> volumes = deformed_volumes(mesh, solution);
  const double volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  measures.volume_change = (volume - mesh.volume()) / mesh.volume();
  measures.volume_error = std::abs(*measures.volume_change);
  double smallest = INFINITY, largest = -INFINITY, smallest_jacobian = INFINITY;
  for (std::size_t c = 0; c < volumes.size(); ++c) {
    const CellNodes& cell = mesh.cells()[c];
    const double ratio = volumes[c] / mesh.cell_volumes()[c];
    smallest = std::min(smallest, ratio);
    largest = std::max(largest, ratio);
    smallest_jacobian = std::min(
        smallest_jacobian, smallest_corner_jacobian(corners(cell, positions)) /
                               smallest_corner_jacobian(corners(cell, mesh.nodes())));
  }
  measures.cell_volume_ratio_min = smallest;
  measures.cell_volume_ratio_max = largest;
  measures.corner_jacobian_ratio_min = smallest_jacobian;
}

void measure_plate(Measures& measures, const CaseSettings& settings, const Scene& scene,
                   const Mesh& mesh, const Solution& solution,
                   std::span<const Vector3> positions) {
  if (scene.plates.size() < 2 || solution.reactions.empty()) return;
  const Plate& plate = scene.plates.back();
  const std::vector<NodeIndex>& nodes = mesh.region(plate.region).nodes;
  const bool moved_arms = solution.lever_arms == LeverArms::deformed;
  const Vector3 centre = moved_arms
                             ? Vector3(plate.motion.centre + plate.motion.translation)
                             : plate.motion.centre;
  Vector3 force = Vector3::Zero(), torque = Vector3::Zero();
  for (const NodeIndex node : nodes) {
    const Vector3& at = moved_arms ? positions[node] : mesh.nodes()[node];
    force += solution.reactions[node];
    torque += (at - centre).cross(solution.reactions[node]);
  }
  measures.force = force;
  measures.torque = torque;
  measures.plate_force_norm = force.norm();
  measures.plate_torque = torque.z();
  if (entry_of(settings.test).turns) return;
  const Scene whole =
      mechanical_scene(in_last_direction(settings, solution.load_fraction), mesh);
  measures.plate_force = force.dot(whole.plates.back().motion.translation.normalized());
}

void measure_traction(Measures& measures, const Scene& scene, const Mesh& mesh,
                      const Solution& solution) {
  if (scene.tractions.empty()) return;
  measures.face_displacement = loaded_face_displacement(mesh, scene, solution);
  if (solution.reactions.empty()) return;
  Vector3 force = Vector3::Zero();
  for (const Vector3& f : traction_forces(mesh, scene)) force += f;
  measures.force = force;
  measures.plate_force = force.norm();
  measures.plate_force_norm = force.norm();
}

void measure_affine(Measures& measures, const CaseSettings& settings, const Scene& scene,
                    const Mesh& mesh, const Solution& solution) {
  if (!scene.boundary_gradient) return;
  if (!solution.reactions.empty()) {
    Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();
    for (const NodeIndex n : mesh.boundary().nodes)
      stress += solution.reactions[n] * mesh.nodes()[n].transpose() / mesh.volume();
    measures.mean_stress = stress;
  }
  const auto deviation = over_free_nodes(mesh, scene, [&](std::size_t n) {
    return (solution.displacements[n] - *scene.boundary_gradient * mesh.nodes()[n])
        .norm();
  });
  const CaseSettings on_the_way = at_largest_load(settings, solution.load_fraction);
  const double imposed =
      largest_imposed_displacement(mesh, mechanical_scene(on_the_way, mesh));
  if (deviation && imposed > 0)
    measures.affine_deviation_relative = deviation->root_mean_square / imposed;
}

}  // namespace

Measures::Value measure_of(const Measures& measures, std::string_view name) {
  Measures::Value found;
  for_each_measure(measures, [&](const Measure& measure, const auto& value) {
    if (measure.name != name || !value) return;
    if constexpr (std::is_same_v<decltype(value), const Measures::Value&>)
      found = *value;
    else
      found = value->norm();
  });
  return found;
}

std::optional<std::string> not_finite(const Measures& measures) {
  std::optional<std::string> found;
  for_each_measure(measures, [&](const Measure& measure, const auto& value) {
    if constexpr (std::is_same_v<decltype(value), const Measures::Value&>) {
      if (value && !std::isfinite(*value)) found = measure.name;
    } else {
      if (value && !value->allFinite()) found = measure.name;
    }
  });
  return found;
}

std::vector<double> deformed_volumes(const Mesh& mesh, const Solution& solution) {
  if (!solution.cell_volumes.empty()) return solution.cell_volumes;
  return cell_volumes(mesh.cells(), deformed(mesh, solution.displacements));
}

Measures::Value definite_up_to_deformation(const CaseSettings& settings,
                                           const Solution& solution) {
  if (!solution.definite_up_to || !settings.deformation) return std::nullopt;
  return *solution.definite_up_to * *settings.deformation;
}

Measures measure(const CaseSettings& settings, const Mesh& mesh,
                 const Solution& solution) {
  Measures measures;
  const CaseSettings loaded = at_load(settings, solution.load_fraction);
  const Scene scene = mechanical_scene(loaded, mesh);
  const std::vector<Vector3> positions = deformed(mesh, solution.displacements);
  measure_volumes(measures, mesh, solution, positions);
  measure_plate(measures, settings, scene, mesh, solution, positions);
  measure_traction(measures, scene, mesh, solution);
  measure_affine(measures, settings, scene, mesh, solution);
  if (settings.test == Test::bending) {
    measures.tip_deflection =
        tip_deflection(in_last_direction(settings, solution.load_fraction), mesh,
                       solution.displacements);
    measure_theory(measures, loaded, mesh, solution.displacements);
  }
  measures.definite_up_to_deformation = definite_up_to_deformation(settings, solution);
  if (settings.method.solve) measures.strain_energy = solution.strain_energy;
  return measures;
}

}  // namespace springcheck
