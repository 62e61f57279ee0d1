#include "meshing/loads/turn.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "meshing/cell_geometry.hpp"

namespace springcheck {
namespace {

using CellIndices = std::vector<std::size_t>;

/// The angle of the same direction in [-pi, pi].
double principal(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

constexpr double right_angle = std::numbers::pi / 2;

/// The turn of the last plate against the first.
double turn_of_plates(const Scene& scene, double load_fraction) {
  return load_fraction *
         (scene.plates.back().motion.angle - scene.plates.front().motion.angle);
}

/// phi of a cell, in [-pi, pi].
double turn_of_cell(const CellNodes& cell, std::span<const Vector3> nodes,
                    std::span<const Vector3> positions, const Vector3& axis) {
  CornerPositions X = corners(cell, nodes), x = corners(cell, positions);
  X.colwise() -= X.rowwise().mean().eval();
  x.colwise() -= x.rowwise().mean().eval();
  const Matrix3 F = (x * X.transpose()) * (X * X.transpose()).inverse();
  const Vector3 skew(F(2, 1) - F(1, 2), F(0, 2) - F(2, 0), F(1, 0) - F(0, 1));
  return std::atan2(axis.dot(skew), F.trace() - axis.dot(F * axis));
}

std::vector<CellIndices> cells_at_nodes(std::span<const CellNodes> cells,
                                        std::size_t nodes) {
  std::vector<CellIndices> cells_at(nodes);
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const NodeIndex n : cells[c]) cells_at[n].push_back(c);
  return cells_at;
}

}  // namespace

bool turns_far(const Scene& scene) {
  return scene.plates.size() >= 2 && std::abs(turn_of_plates(scene, 1)) > right_angle;
}

std::optional<double> shown_turn(const Mesh& mesh, const Scene& scene,
                                 const CellsBetween& between,
                                 std::span<const Vector3> positions,
                                 double load_fraction) {
  if (scene.plates.size() < 2) return std::nullopt;
  const Plate &first = scene.plates.front(), &last = scene.plates.back();
  const double imposed = turn_of_plates(scene, load_fraction);
  if (std::abs(imposed) <= right_angle) return std::nullopt;

  const auto& [cells, rest] = between;
  const std::vector<CellIndices> cells_at = cells_at_nodes(cells, rest.size());
  std::vector<double> turns(cells.size());
  std::vector<bool> is_known(cells.size(), false);
  CellIndices next;
  const auto visit = [&](const auto& nodes, double from) {
    for (const NodeIndex n : nodes)
      for (const std::size_t c : cells_at[n]) {
        if (is_known[c]) continue;
        is_known[c] = true;
        const double turn = turn_of_cell(cells[c], rest, positions, last.motion.axis);
        turns[c] = from + principal(turn - from);
        next.push_back(c);
      }
  };
  visit(mesh.region(first.region).nodes, load_fraction * first.motion.angle);
  for (std::size_t i = 0; i < next.size(); ++i) {
    const std::size_t c = next[i];
    visit(cells[c], turns[c]);
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

std::optional<double> shown_turn(const Mesh& mesh, const Scene& scene,
                                 std::span<const Vector3> positions,
                                 double load_fraction) {
  return shown_turn(mesh, scene, {mesh.cells(), mesh.nodes()}, positions, load_fraction);
}

bool shows_imposed_turn(const Mesh& mesh, const Scene& scene, const CellsBetween& between,
                        std::span<const Vector3> positions, double load_fraction) {
  const auto shown = shown_turn(mesh, scene, between, positions, load_fraction);
  return !shown ||
         std::abs(*shown - turn_of_plates(scene, load_fraction)) < std::numbers::pi;
}

bool shows_imposed_turn(const Mesh& mesh, const Scene& scene,
                        std::span<const Vector3> positions, double load_fraction) {
  return shows_imposed_turn(mesh, scene, {mesh.cells(), mesh.nodes()}, positions,
                            load_fraction);
}

}  // namespace springcheck
