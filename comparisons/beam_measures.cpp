#include "comparisons/beam_measures.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/beam_theory.hpp"

namespace springcheck {
namespace {

constexpr double on_plane = 1e-9;  // of the block's height: coordinates are exact

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

}  // namespace

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

}  // namespace springcheck
