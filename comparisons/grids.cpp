#include "comparisons/grids.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

std::vector<Vector3> at_coarse_nodes(std::span<const Vector3> field, const Cells& fine,
                                     const Cells& coarse) {
  const auto [sx, sy, sz] = multiples(fine, coarse);
  const auto fine_nodes = nodes_of(fine);
  std::vector<Vector3> values;
  for_each_point(nodes_of(coarse), [&](int x, int y, int z, std::size_t) {
    values.push_back(field[number_of(fine_nodes, sx * x, sy * y, sz * z)]);
  });
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
