#include "comparisons/wrinkles.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace springcheck {
namespace {

/// Along one axis, the node after each node of a face.
using NextNode = std::map<NodeIndex, NodeIndex>;

NextNode grid_lines(const Mesh& mesh, const Region& region, Eigen::Index axis) {
  NextNode next;
  for (const FaceNodes& face : region.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const NodeIndex a = face[i], b = face[(i + 1) % face.size()];
      const Vector3 edge = mesh.nodes()[b] - mesh.nodes()[a];
      Eigen::Index longest = 0;
      edge.cwiseAbs().maxCoeff(&longest);
      if (longest != axis) continue;
      if (edge[axis] > 0)
        next[a] = b;
      else
        next[b] = a;
    }
  return next;
}

Vector3 rest_normal(const Mesh& mesh, const FaceNodes& face) {
  const auto& x = mesh.nodes();
  return (x[face[2]] - x[face[0]]).cross(x[face[3]] - x[face[1]]).normalized();
}

Wrinkling zigzag(const Mesh& mesh, const Region& region, Eigen::Index axis, double strain,
                 std::span<const Vector3> displacements) {
  const Vector3 normal = rest_normal(mesh, region.faces.front());
  const NextNode next = grid_lines(mesh, region, axis);
  std::map<NodeIndex, double> second_difference;  // at the middle node
  double square_sum = 0, edge_sum = 0;
  for (const auto& [before, middle] : next) {
    const auto after = next.find(middle);
    if (after == next.end()) continue;
    const double d2 = normal.dot(displacements[before] - 2 * displacements[middle] +
                                 displacements[after->second]);
    second_difference[middle] = d2;
    square_sum += d2 * d2;
    edge_sum += (mesh.nodes()[middle] - mesh.nodes()[before]).norm();
  }
  double product_sum = 0, pairs = 0;
  for (const auto& [middle, d2] : second_difference)
    if (const auto neighbour = second_difference.find(next.at(middle));
        neighbour != second_difference.end()) {
      product_sum += d2 * neighbour->second;
      ++pairs;
    }
  const auto count = static_cast<double>(second_difference.size());
  const double per_line = count / (count - pairs);
  if (square_sum == 0)
    return {.alternation = -1, .amplitude = 0, .differences = per_line, .strain = strain};
  return {.alternation = -product_sum / square_sum,
          .amplitude = std::sqrt(square_sum / count) / (4 * edge_sum / count * strain),
          .differences = per_line,
          .strain = strain};
}

/// Young's modulus along the axis [Pa].
double axial_modulus(const CaseSettings& settings) {
  if (!is_custom(settings.method)) return settings.material.young_modulus;
  const double cell_edge = settings.body.block.size[0] / settings.body.block.cells[0];
  return mss::axial_modulus(settings.constants.value(), cell_edge);
}

}  // namespace

std::optional<Wrinkling> measure_wrinkling(const Mesh& mesh, const Scene& scene,
                                           double strain,
                                           std::span<const Vector3> displacements) {
  if (scene.boundary_gradient) return std::nullopt;
  Wrinkling worst{.alternation = -1, .amplitude = 0, .differences = 0, .strain = strain};
  for (const auto& [name, region] : mesh.regions()) {
    if (std::ranges::any_of(scene.plates,
                            [&](const Plate& plate) { return plate.region == name; }))
      continue;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Wrinkling here = zigzag(mesh, region, axis, strain, displacements);
      const auto rank = [](const Wrinkling& w) {
        return std::pair(is_wrinkled(w), w.alternation);
      };
      if (rank(here) > rank(worst)) worst = here;
    }
  }
  return worst;
}

bool is_wrinkled(const Wrinkling& wrinkling) {
  constexpr double high = 0.02, high_bulge = 0.28;  // the latter times the strain
  if (wrinkling.differences < 2.5) return false;
  const bool short_line = wrinkling.differences < 3.5;
  return wrinkling.alternation > 0.5 &&
         wrinkling.amplitude >
             (short_line ? std::max(high, high_bulge * wrinkling.strain) : high);
}

double imposed_strain(const CaseSettings& settings) {
  const auto [size_x, size_y, length] = settings.body.block.size;
  switch (settings.test) {
    case Test::compression:
    case Test::tension:
    case Test::shearing:
      return *settings.deformation;
    case Test::uniaxial:
      return std::abs(*settings.deformation);
    case Test::torsion:
      return std::abs(*settings.deformation) * std::min(size_x, size_y) / 2 / length;
    case Test::traction: {
      const Vector3 t = settings.traction.cwiseAbs();
      return (t.z() + 6 * length * (t.x() / size_x + t.y() / size_y)) /
             axial_modulus(settings);
    }
    case Test::affine:
      return settings.gradient.norm();
    case Test::bending:
      break;
  }
  const Vector3 down = settings.gravity.normalized();
  const double height = std::abs(down.x()) > std::abs(down.y()) ? size_x : size_y;
  // (h/2) w L^2/(2 E I) with w/I = 12 rho g/h^2, the width cancelling.
  return 3 * settings.material.density * settings.gravity.norm() * length * length /
         (axial_modulus(settings) * height);
}

}  // namespace springcheck
