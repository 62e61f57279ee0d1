#include "comparisons/measures/beam_measures.hpp"

#include <algorithm>
#include <cmath>

namespace springcheck {
namespace {

constexpr double on_line = 1e-9;  // of the block's height: coordinates are exact

/// Nodes of the centre line from the clamp to the tip; empty unless they stand in a grid
/// whose x and y counts are even.
std::vector<NodeIndex> centre_line(const CaseSettings& settings, const Mesh& mesh) {
  std::vector<NodeIndex> line;
  if (!has_nodes_in_layers(settings.body)) return line;
  const auto [width, depth, height] = settings.body.block.size;
  for (NodeIndex n = 0; n < mesh.nodes().size(); ++n)
    if (std::abs(mesh.nodes()[n].x() - width / 2) < on_line * height &&
        std::abs(mesh.nodes()[n].y() - depth / 2) < on_line * height)
      line.push_back(n);
  std::ranges::sort(line, {}, [&](NodeIndex n) { return mesh.nodes()[n].z(); });
  return line;
}

/// The displacement at a point of a plane, horizontal region, linear on the triangles
/// that its faces' nodes span with the faces' centres; none where no face has the point.
std::optional<Vector3> on_face(const Mesh& mesh, const Region& region,
                               std::span<const Vector3> displacements,
                               const Vector3& point) {
  constexpr double rounding = 1e-9;  // of a triangle's area
  for (const FaceNodes& face : region.faces) {
    Vector3 centre = Vector3::Zero(), at_centre = Vector3::Zero();
    for (const NodeIndex n : face) {
      centre += mesh.nodes()[n] / static_cast<double>(face.size());
      at_centre += displacements[n] / static_cast<double>(face.size());
    }
    for (std::size_t i = 0; i < face.size(); ++i) {
      const NodeIndex a = face[i], b = face[(i + 1) % face.size()];
      const auto area = [](const Vector3& p, const Vector3& q, const Vector3& r) {
        return (q - p).cross(r - p).z();
      };
      const Vector3 &x_a = mesh.nodes()[a], &x_b = mesh.nodes()[b];
      const double whole = area(x_a, x_b, centre);
      const Vector3 weights = Vector3(area(point, x_b, centre), area(x_a, point, centre),
                                      area(x_a, x_b, point)) /
                              whole;
      if (weights.minCoeff() >= -rounding)
        return weights[0] * displacements[a] + weights[1] * displacements[b] +
               weights[2] * at_centre;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> tip_deflection(const CaseSettings& settings, const Mesh& mesh,
                                     std::span<const Vector3> displacements) {
  if (settings.body.shape != BodyShape::block || settings.gravity.isZero(0) ||
      !mesh.regions().contains(settings.body.moved))  // a cut has taken it
    return std::nullopt;
  const auto [width, depth, height] = settings.body.block.size;
  const auto tip = on_face(mesh, mesh.region(settings.body.moved), displacements,
                           Vector3(width / 2, depth / 2, height));
  return tip ? std::optional(tip->dot(settings.gravity.normalized())) : std::nullopt;
}

std::optional<Cantilever> cantilever(const std::array<double, 3>& size,
                                     const Material& material, const Vector3& gravity) {
  const auto [size_x, size_y, length] = size;
  const Vector3 down = gravity.normalized();
  const bool along_x = std::abs(down.x()) > 1 - 1e-12;
  if (!along_x && std::abs(down.y()) < 1 - 1e-12) return std::nullopt;
  return Cantilever{
      .length = length,
      .width = along_x ? size_y : size_x,
      .height = along_x ? size_x : size_y,
      .young_modulus = material.young_modulus,
      .shear_modulus = lame_constants(material).mu,
      .load_per_length = material.density * gravity.norm() * size_x * size_y};
}

void measure_theory(Measures& measures, const CaseSettings& settings, const Mesh& mesh,
                    std::span<const Vector3> displacements) {
  if (settings.gravity.isZero(0) || settings.body.shape != BodyShape::block ||
      !settings.body.cuts.empty())
    return;
  if (!settings.method.is_elastic) return;  // it has no modulus for a theory
  const auto of_settings =
      cantilever(settings.body.block.size, settings.material, settings.gravity);
  if (!of_settings) return;
  const Cantilever& beam = *of_settings;
  const Vector3 down = settings.gravity.normalized();
  const Vector3 across = down.cross(Vector3::UnitZ());  // to the plane of bending
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
      distance =
          std::max(*distance, std::hypot(u.dot(down) - theory[i].drop,
                                         s[i] + u.z() - theory[i].axial, u.dot(across)));
    }
  };
  if (line.empty()) s = {beam.length};
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

}  // namespace springcheck
