#include "comparisons/measures/displacement_norms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshing/loads/traction.hpp"

namespace springcheck {
namespace {

/// Volume each node stands for: of each of its cells an equal share with its others.
std::vector<double> nodal_volumes(const Mesh& mesh) {
  std::vector<double> volumes(mesh.nodes().size(), 0);
  for (std::size_t c = 0; c < mesh.cells().size(); ++c)
    for (const NodeIndex node : mesh.cells()[c])
      volumes[node] +=
          mesh.cell_volumes()[c] / static_cast<double>(mesh.cells()[c].size());
  return volumes;
}

}  // namespace

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

double largest_imposed_displacement(const Mesh& mesh, const Scene& scene) {
  double largest = 0;
  for (const Plate& plate : scene.plates) {
    const double half_turn = std::numbers::pi / std::abs(plate.motion.angle);
    for (const double s : {std::min(half_turn, 1.), 1.})
      for (const NodeIndex n : mesh.region(plate.region).nodes)
        largest =
            std::max(largest, displacement(plate.motion, mesh.nodes()[n], s).norm());
  }
  if (scene.boundary_gradient)
    for (const NodeIndex n : mesh.boundary().nodes)
      largest = std::max(largest, (*scene.boundary_gradient * mesh.nodes()[n]).norm());
  return largest;
}

Vector3 loaded_face_displacement(const Mesh& mesh, const Scene& scene,
                                 const Solution& solution) {
  if (!solution.loaded_face_displacements.empty())
    return solution.loaded_face_displacements.front();
  const auto areas = nodal_areas(mesh, mesh.region(scene.tractions.front().region));
  Vector3 integral = Vector3::Zero();
  double area = 0;
  for (std::size_t n = 0; n < areas.size(); ++n) {
    integral += areas[n] * solution.displacements[n];
    area += areas[n];
  }
  return integral / area;
}

}  // namespace springcheck
