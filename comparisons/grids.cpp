#include "comparisons/grids.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "meshing/input_error.hpp"

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

/// A place along an axis of a grid: a cell, and the fraction of it that lies before.
struct Place {
  int cell;
  double beyond;  // in [0, 1]
};

Place place_on(double size, int cells, double x) {
  constexpr double rounding = 1e-9;
  double at = std::clamp(x / size * cells, 0., static_cast<double>(cells));
  if (std::abs(at - std::round(at)) < rounding) at = std::round(at);
  const int cell = std::min(static_cast<int>(at), cells - 1);
  return {.cell = cell, .beyond = at - cell};
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
    std::array<Place, 3> places;
    for (std::size_t i = 0; i < 3; ++i)
      places[i] = place_on(grid.size[i], grid.cells[i], point[static_cast<int>(i)]);
    Vector3 value = Vector3::Zero();
    for_each_point({2, 2, 2}, [&](int x, int y, int z, std::size_t) {
      const std::array<int, 3> side{x, y, z};
      double weight = 1;
      std::array<int, 3> node{};
      for (std::size_t i = 0; i < 3; ++i) {
        weight *= side[i] == 0 ? 1 - places[i].beyond : places[i].beyond;
        node[i] = places[i].cell + side[i];
      }
      if (weight != 0)
        value += weight * field[number_of(nodes, node[0], node[1], node[2])];
    });
    values.push_back(value);
  }
  return values;
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
