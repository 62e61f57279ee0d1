#include "meshing/turn.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "meshing/cell_geometry.hpp"

namespace springcheck {
namespace {

using Matrix3 = Eigen::Matrix3d;
using CellIndices = std::vector<std::size_t>;

/// Of the same direction, in [-pi, pi].
double principal(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

double turn_of_plates(const Scene& scene, double load_fraction) {
  return load_fraction *
         (scene.plates.back().motion.angle - scene.plates.front().motion.angle);
}

/// phi of a cell, in [-pi, pi].
double turn_of_cell(const CellNodes& cell, const Mesh& mesh,
                    std::span<const Vector3> positions, const Vector3& axis) {
  CornerPositions X = corners(cell, mesh.nodes()), x = corners(cell, positions);
  X.colwise() -= X.rowwise().mean().eval();
  x.colwise() -= x.rowwise().mean().eval();
  const Matrix3 F = (x * X.transpose()) * (X * X.transpose()).inverse();
  const Vector3 skew(F(2, 1) - F(1, 2), F(0, 2) - F(2, 0), F(1, 0) - F(0, 1));
  return std::atan2(axis.dot(skew), F.trace() - axis.dot(F * axis));
}

std::vector<CellIndices> cells_at_nodes(const Mesh& mesh) {
  std::vector<CellIndices> cells(mesh.nodes().size());
  for (std::size_t c = 0; c < mesh.cells().size(); ++c)
    for (const NodeIndex n : mesh.cells()[c]) cells[n].push_back(c);
  return cells;
}

}  // namespace

std::optional<double> shown_turn(const Mesh& mesh, const Scene& scene,
                                 std::span<const Vector3> positions,
                                 double load_fraction) {
  if (scene.plates.size() < 2) return std::nullopt;
  const Plate &first = scene.plates.front(), &last = scene.plates.back();
  const double imposed = turn_of_plates(scene, load_fraction);
  if (std::abs(imposed) <= std::numbers::pi / 2) return std::nullopt;

  const std::vector<CellIndices> cells_at = cells_at_nodes(mesh);
  std::vector<double> turns(mesh.cells().size());
  std::vector<bool> is_known(mesh.cells().size(), false);
  CellIndices next;
  const auto visit = [&](const auto& nodes, double from) {
    for (const NodeIndex n : nodes)
      for (const std::size_t c : cells_at[n]) {
        if (is_known[c]) continue;
        is_known[c] = true;
        const double turn =
            turn_of_cell(mesh.cells()[c], mesh, positions, last.motion.axis);
        turns[c] = from + principal(turn - from);
        next.push_back(c);
      }
  };
  visit(mesh.region(first.region).nodes, load_fraction * first.motion.angle);
  for (std::size_t i = 0; i < next.size(); ++i) {
    const std::size_t c = next[i];
    visit(mesh.cells()[c], turns[c]);
  }

  double sum = 0, count = 0;
  for (const NodeIndex n : mesh.region(last.region).nodes)
    for (const std::size_t c : cells_at[n])
      if (is_known[c]) {
        sum += turns[c] - load_fraction * first.motion.angle;
        ++count;
      }
  if (count == 0) return std::nullopt;  // the plates hold separate parts
  return sum / count + principal(imposed - sum / count);
}

bool shows_imposed_turn(const Mesh& mesh, const Scene& scene,
                        std::span<const Vector3> positions, double load_fraction) {
  const auto shown = shown_turn(mesh, scene, positions, load_fraction);
  return !shown ||
         std::abs(*shown - turn_of_plates(scene, load_fraction)) < std::numbers::pi;
}

}  // namespace springcheck
