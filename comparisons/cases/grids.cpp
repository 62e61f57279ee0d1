#include "comparisons/cases/grids.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

/// Calls visit(x, y, z, n) for the points of an nx * ny * nz lattice, n counting them.
template <class Visit>
void for_each_point(const std::array<int, 3>& points, Visit&& visit) {
  std::size_t n = 0;
  for (int z = 0; z < points[2]; ++z)
    for (int y = 0; y < points[1]; ++y)
      for (int x = 0; x < points[0]; ++x) visit(x, y, z, n++);
}

std::size_t number_of(const std::array<int, 3>& points, int x, int y, int z) {
  const auto [nx, ny, nz] = points;
  return static_cast<std::size_t>(x) +
         static_cast<std::size_t>(nx) *
             (static_cast<std::size_t>(y) +
              static_cast<std::size_t>(ny) * static_cast<std::size_t>(z));
}

std::array<int, 3> nodes_of(const Cells& cells) {
  return {cells[0] + 1, cells[1] + 1, cells[2] + 1};
}

std::array<int, 3> multiples(const Cells& fine, const Cells& coarse) {
  assert(is_refinement(fine, coarse));
  return {fine[0] / coarse[0], fine[1] / coarse[1], fine[2] / coarse[2]};
}

/// Nodes along an axis of a grid, from `first` on, whose values determine a field's at a
/// place between them, and by how much each.
struct Weights {
  int first;
  std::vector<double> of;
};

constexpr double rounding = 1e-9;  // of a cell

/// Lagrange's polynomials, of degree 2 on pairs of cells or 1 on single ones.
Weights weights_at(double size, int cells, double x) {
  double at = std::clamp(x / size * cells, 0., static_cast<double>(cells));
  if (std::abs(at - std::round(at)) < rounding) at = std::round(at);
  const int width = cells % 2 == 0 ? 2 : 1;
  const int first = std::min(static_cast<int>(at) / width * width, cells - width);
  const double t = at - first;
  if (width == 1) return {.first = first, .of = {1 - t, t}};
  return {.first = first, .of = {(t - 1) * (t - 2) / 2, t * (2 - t), t * (t - 1) / 2}};
}

}  // namespace

Cells refined(const Cells& cells, int factor) {
  Cells all{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (cells[i] > std::numeric_limits<int>::max() / factor)
      throw InputError("cells", fmt::format("refined {} times", factor),
                       "counts below 2^31",
                       fmt::format("{} x {}", factor, fmt::join(cells, ",")));
    all[i] = factor * cells[i];
  }
  return all;
}

Cells coarsened(const Cells& cells) {
  return {cells[0] / 2 + cells[0] % 2, cells[1] / 2 + cells[1] % 2,
          cells[2] / 2 + cells[2] % 2};
}

bool is_refinement(const Cells& fine, const Cells& coarse) {
  return fine[0] % coarse[0] == 0 && fine[1] % coarse[1] == 0 && fine[2] % coarse[2] == 0;
}

double cell_size(const Block& block) {
  const auto [lx, ly, lz] = block.size;
  const auto [nx, ny, nz] = block.cells;
  return std::cbrt(lx / nx * (ly / ny) * (lz / nz));
}

std::vector<Vector3> interpolated(std::span<const Vector3> field, const Block& grid,
                                  std::span<const Vector3> points) {
  const auto nodes = nodes_of(grid.cells);
  std::vector<Vector3> values;
  values.reserve(points.size());
  for (const Vector3& point : points) {
    std::array<Weights, 3> weights;
    std::array<int, 3> counts{};
    for (std::size_t i = 0; i < 3; ++i) {
      weights[i] = weights_at(grid.size[i], grid.cells[i], point[static_cast<int>(i)]);
      counts[i] = static_cast<int>(weights[i].of.size());
    }
    const auto& [along_x, along_y, along_z] = weights;
    Vector3 value = Vector3::Zero();
    for_each_point(counts, [&](int x, int y, int z, std::size_t) {
      const double weight = along_x.of[static_cast<std::size_t>(x)] *
                            along_y.of[static_cast<std::size_t>(y)] *
                            along_z.of[static_cast<std::size_t>(z)];
      if (weight != 0)
        value += weight * field[number_of(nodes, along_x.first + x, along_y.first + y,
                                          along_z.first + z)];
    });
    values.push_back(value);
  }
  return values;
}

bool are_nodes_of(const Block& grid, std::span<const Vector3> points) {
  return std::ranges::all_of(points, [&](const Vector3& point) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double at = point[static_cast<int>(i)] / grid.size[i] * grid.cells[i];
      if (std::abs(at - std::round(at)) > rounding) return false;
    }
    return true;
  });
}

std::vector<double> summed_over_coarse_cells(std::span<const double> values,
                                             const Cells& fine, const Cells& coarse) {
  const auto [sx, sy, sz] = multiples(fine, coarse);
  std::vector<double> sums(number_of(coarse, 0, 0, coarse[2]), 0);
  for_each_point(fine, [&](int x, int y, int z, std::size_t n) {
    sums[number_of(coarse, x / sx, y / sy, z / sz)] += values[n];
  });
  return sums;
}

}  // namespace springcheck
