#include "meshing/quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace springcheck {
namespace {

constexpr std::array<CornerPatch, 4> tetrahedron_corners{
    {{0, 1, 2, 3}, {1, 2, 0, 3}, {2, 0, 1, 3}, {3, 0, 2, 1}}};
constexpr std::array<CornerPatch, 8> pyramid_corners{{{0, 1, 3, 4},
                                                      {1, 2, 0, 4},
                                                      {2, 3, 1, 4},
                                                      {3, 0, 2, 4},
                                                      {4, 2, 1, 0},
                                                      {4, 3, 2, 1},
                                                      {4, 0, 3, 2},
                                                      {4, 1, 0, 3}}};

/// Unlike corner_patches, which lists no corner whose determinant is another's.
std::span<const CornerPatch> all_corners(CellType type) {
  if (type == CellType::tetrahedron) return tetrahedron_corners;
  if (type == CellType::pyramid) return pyramid_corners;
  return corner_patches(type);
}

double regular_corner(CellType type) {
  switch (type) {
    case CellType::tetrahedron:
    case CellType::pyramid:
      return 1 / std::numbers::sqrt2;
    case CellType::prism:
      return std::numbers::sqrt3 / 2;
    default:
      return 1;
  }
}

/// Adds one cell; the means hold sums until all are there.
void add(CellQuality& quality, double volume, const CornerPositions& x) {
  const double jacobian = scaled_jacobian(x), ratio = edge_ratio(x);
  ++quality.cells;
  quality.volume += volume;
  quality.smallest_volume = std::min(quality.smallest_volume, volume);
  quality.largest_volume = std::max(quality.largest_volume, volume);
  quality.smallest_scaled_jacobian = std::min(quality.smallest_scaled_jacobian, jacobian);
  quality.mean_scaled_jacobian += jacobian;
  quality.largest_edge_ratio = std::max(quality.largest_edge_ratio, ratio);
  quality.mean_edge_ratio += ratio;
  ++quality.histogram[static_cast<std::size_t>(std::clamp(10 * jacobian, 0., 9.))];
}

CellQuality none() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {.cells = 0,
          .volume = 0,
          .smallest_volume = infinity,
          .mean_volume = 0,
          .largest_volume = 0,
          .smallest_scaled_jacobian = infinity,
          .mean_scaled_jacobian = 0,
          .largest_edge_ratio = 0,
          .mean_edge_ratio = 0};
}

void divide_sums(CellQuality& quality) {
  const auto cells = static_cast<double>(quality.cells);
  quality.mean_volume = quality.volume / cells;
  quality.mean_scaled_jacobian /= cells;
  quality.mean_edge_ratio /= cells;
}

}  // namespace

double scaled_jacobian(const CornerPositions& x) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& [corner, a, b, c] : all_corners(type_of(x))) {
    const Vector3 to_a = x.col(a) - x.col(corner), to_b = x.col(b) - x.col(corner),
                  to_c = x.col(c) - x.col(corner);
    const double lengths = to_a.norm() * to_b.norm() * to_c.norm();
    smallest = std::min(smallest, to_a.dot(to_b.cross(to_c)) / lengths);
  }
  return smallest / regular_corner(type_of(x));
}

double edge_ratio(const CornerPositions& x) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (const auto& [a, b] : edges(type_of(x))) {
    const double length =
        (x.col(static_cast<Eigen::Index>(a)) - x.col(static_cast<Eigen::Index>(b)))
            .norm();
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  return longest / shortest;
}

Quality quality_of(const Mesh& mesh) {
  Quality quality{.all = none()};
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const CornerPositions x = corners(mesh.cells()[c], mesh.nodes());
    CellQuality& of_type = quality.by_type.try_emplace(type_of(x), none()).first->second;
    add(of_type, mesh.cell_volumes()[c], x);
    add(quality.all, mesh.cell_volumes()[c], x);
  }
  for (auto& [type, of_type] : quality.by_type) divide_sums(of_type);
  divide_sums(quality.all);
  return quality;
}

}  // namespace springcheck
