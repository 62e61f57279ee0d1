#include "comparisons/measures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>

#include "comparisons/beam_theory.hpp"
#include "meshing/hexahedron.hpp"
#include "meshing/traction.hpp"

namespace springcheck {
namespace {

constexpr double on_plane = 1e-9;  // of the block's height: coordinates are exact

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
    const Hexahedron& cell = mesh.hexahedra()[c];
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
  if (scene.plates.size() < 2) return;
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
  if (settings.test != Test::torsion)
    measures.plate_force = force.dot(plate.motion.translation.normalized());
}

/// int u dA/A over the face that the scene's traction loads [m].
Vector3 loaded_face_displacement(const Mesh& mesh, const Scene& scene,
                                 std::span<const Vector3> displacements) {
  const auto areas = nodal_areas(mesh, mesh.region(scene.tractions.front().region));
  Vector3 integral = Vector3::Zero();
  double area = 0;
  for (std::size_t n = 0; n < areas.size(); ++n) {
    integral += areas[n] * displacements[n];
    area += areas[n];
  }
  return integral / area;
}

void measure_traction(Measures& measures, const Scene& scene, const Mesh& mesh,
                      const Solution& solution) {
  if (scene.tractions.empty()) return;
  Vector3 force = Vector3::Zero();
  for (const Vector3& f : traction_forces(mesh, scene)) force += f;
  measures.force = force;
  measures.plate_force = force.norm();
  measures.plate_force_norm = force.norm();
  measures.face_displacement =
      loaded_face_displacement(mesh, scene, solution.displacements);
}

/// Volume each node stands for: an eighth of each of its cells.
std::vector<double> nodal_volumes(const Mesh& mesh) {
  std::vector<double> volumes(mesh.nodes().size(), 0);
  for (std::size_t c = 0; c < mesh.hexahedra().size(); ++c)
    for (const NodeIndex node : mesh.hexahedra()[c])
      volumes[node] += mesh.cell_volumes()[c] / 8;
  return volumes;
}

/// Volume-weighted root mean square, and largest, of a distance over the nodes with a
/// free component; none without such nodes.
struct FreeDistance {
  double root_mean_square;
  double largest;
};
std::optional<FreeDistance> over_free_nodes(
    const Mesh& mesh, const Scene& scene,
    const std::function<double(std::size_t)>& distance) {
  const std::vector<bool> is_free =
      free_components(mesh, prescribed_components(mesh, scene));
  const std::vector<double> weights = nodal_volumes(mesh);
  double square_sum = 0, weight = 0, largest = 0;
  for (std::size_t n = 0; n < weights.size(); ++n) {
    if (!is_free[3 * n] && !is_free[3 * n + 1] && !is_free[3 * n + 2]) continue;
    const double d = distance(n);
    square_sum += weights[n] * d * d;
    weight += weights[n];
    largest = std::max(largest, d);
  }
  if (weight == 0) return std::nullopt;
  return FreeDistance{.root_mean_square = std::sqrt(square_sum / weight),
                      .largest = largest};
}

/// Largest displacement that the plates or the boundary gradient impose on a node [m].
double largest_imposed_displacement(const Mesh& mesh, const Scene& scene) {
  double largest = 0;
  for (const Plate& plate : scene.plates)
    for (const NodeIndex n : mesh.region(plate.region).nodes)
      largest = std::max(largest, displacement(plate.motion, mesh.nodes()[n], 1).norm());
  if (scene.boundary_gradient)
    for (const NodeIndex n : mesh.boundary().nodes)
      largest = std::max(largest, (*scene.boundary_gradient * mesh.nodes()[n]).norm());
  return largest;
}

void measure_affine(Measures& measures, const Scene& scene, const Mesh& mesh,
                    const Solution& solution) {
  if (!scene.boundary_gradient) return;
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();
  for (const NodeIndex n : mesh.boundary().nodes)
    stress += solution.reactions[n] * mesh.nodes()[n].transpose() / mesh.volume();
  measures.mean_stress = stress;
  const auto deviation = over_free_nodes(mesh, scene, [&](std::size_t n) {
    return (solution.displacements[n] - *scene.boundary_gradient * mesh.nodes()[n])
        .norm();
  });
  if (deviation)
    measures.affine_deviation_relative =
        deviation->root_mean_square / largest_imposed_displacement(mesh, scene);
}

/// Nodes of the centre line from the clamp to the tip; empty unless x and y counts are
/// even.
std::vector<NodeIndex> centre_line(const CaseSettings& settings, const Mesh& mesh) {
  std::vector<NodeIndex> line;
  const auto [width, depth, height] = settings.block.size;
  for (NodeIndex n = 0; n < mesh.nodes().size(); ++n)
    if (std::abs(mesh.nodes()[n].x() - width / 2) < on_plane * height &&
        std::abs(mesh.nodes()[n].y() - depth / 2) < on_plane * height)
      line.push_back(n);
  std::ranges::sort(line, {}, [&](NodeIndex n) { return mesh.nodes()[n].z(); });
  return line;
}

std::optional<double> tip_deflection(const CaseSettings& settings, const Mesh& mesh,
                                     std::span<const Vector3> displacements) {
  const std::vector<NodeIndex> line = centre_line(settings, mesh);
  if (line.empty()) return std::nullopt;
  return displacements[line.back()].dot(settings.gravity.normalized());
}

void measure_beam(Measures& measures, const CaseSettings& settings, const Mesh& mesh,
                  std::span<const Vector3> displacements) {
  if (settings.test != Test::bending || settings.gravity.isZero(0)) return;
  measures.tip_deflection = tip_deflection(settings, mesh, displacements);
  const auto [size_x, size_y, length] = settings.block.size;
  const Vector3 down = settings.gravity.normalized();
  // The theories know a load across one side of the section only.
  const bool along_x = std::abs(down.x()) > 1 - 1e-12;
  if (!along_x && std::abs(down.y()) < 1 - 1e-12) return;
  const Cantilever beam{.length = length,
                        .width = along_x ? size_y : size_x,
                        .height = along_x ? size_x : size_y,
                        .young_modulus = settings.material.young_modulus,
                        .shear_modulus = lame_constants(settings.material).mu,
                        .load_per_length = settings.material.density *
                                           settings.gravity.norm() * size_x * size_y};
  const std::vector<NodeIndex> line = centre_line(settings, mesh);
  std::vector<double> s;
  for (const NodeIndex n : line) s.push_back(mesh.nodes()[n].z());

  const auto compare = [&](const std::vector<BeamPoint>& theory, Measures::Value& tip,
                           Measures::Value& distance) {
    tip = theory.back().drop;
    if (line.empty()) return;
    distance = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vector3& u = displacements[line[i]];
      distance = std::max(*distance, std::hypot(u.dot(down) - theory[i].drop,
                                                s[i] + u.z() - theory[i].axial));
    }
  };
  if (line.empty()) s = {length};
  const auto each = [&](auto&& theory) {
    std::vector<BeamPoint> points;
    for (const double at : s) points.push_back(theory(beam, at));
    return points;
  };
  compare(each(euler_bernoulli), measures.tip_euler_bernoulli,
          measures.centre_line_euler_bernoulli);
  compare(each(timoshenko), measures.tip_timoshenko, measures.centre_line_timoshenko);
  compare(elastica(beam, s), measures.tip_elastica, measures.centre_line_elastica);
}

/// The length deviations are divided by: the largest imposed displacement, or the
/// reference's tip deflection in bending and face displacement in traction.
std::optional<double> imposed_length(const CaseSettings& settings, const Scene& scene,
                                     const Mesh& mesh,
                                     std::span<const Vector3> reference) {
  if (settings.test == Test::bending) return tip_deflection(settings, mesh, reference);
  if (settings.test == Test::traction)
    return loaded_face_displacement(mesh, scene, reference).norm();
  return largest_imposed_displacement(mesh, scene);
}

}  // namespace

std::vector<double> deformed_volumes(const Mesh& mesh, const Solution& solution) {
  if (!solution.cell_volumes.empty()) return solution.cell_volumes;
  return cell_volumes(mesh.hexahedra(), deformed(mesh, solution.displacements));
}

Measures measure(const CaseSettings& settings, const Mesh& mesh,
                 const Solution& solution) {
  Measures measures;
  const Scene scene = mechanical_scene(settings);
  const std::vector<Vector3> positions = deformed(mesh, solution.displacements);
  measure_volumes(measures, mesh, solution, positions);
  measure_plate(measures, settings, scene, mesh, solution, positions);
  measure_traction(measures, scene, mesh, solution);
  measure_affine(measures, scene, mesh, solution);
  measure_beam(measures, settings, mesh, solution.displacements);
  if (solution.definite_up_to && settings.deformation)
    measures.definite_up_to_deformation =
        *solution.definite_up_to * *settings.deformation;
  measures.strain_energy = solution.strain_energy;
  return measures;
}

void measure_deviation(Measures& measures, const CaseSettings& settings, const Mesh& mesh,
                       const Solution& solution, const Solution& reference) {
  const Scene scene = mechanical_scene(settings);
  const double height = settings.block.size[2];
  const auto distance = [&](std::size_t n) {
    return (solution.displacements[n] - reference.displacements[n]).norm();
  };
  double sum = 0, largest = 0, layer_sum = 0;
  int layer_nodes = 0;
  for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
    sum += distance(n);
    largest = std::max(largest, distance(n));
    if (std::abs(mesh.nodes()[n].z() - height / 2) < on_plane * height) {
      layer_sum += distance(n);
      ++layer_nodes;
    }
  }
  measures.mean_deviation = sum / static_cast<double>(mesh.nodes().size());
  measures.max_deviation = largest;
  if (layer_nodes > 0) measures.middle_layer_deviation = layer_sum / layer_nodes;
  const auto length = imposed_length(settings, scene, mesh, reference.displacements);
  const auto free = over_free_nodes(mesh, scene, distance);
  if (length && *length > 0 && free) {
    measures.deviation_l2_relative = free->root_mean_square / *length;
    measures.deviation_max_relative = free->largest / *length;
  }

  const auto volumes = deformed_volumes(mesh, solution),
             reference_volumes = deformed_volumes(mesh, reference);
  double square_sum = 0;
  for (std::size_t c = 0; c < volumes.size(); ++c)
    square_sum += std::pow(volumes[c] - reference_volumes[c], 2) / mesh.cell_volumes()[c];
  measures.cell_volume_ratio_rms_difference = std::sqrt(square_sum / mesh.volume());
}

}  // namespace springcheck
