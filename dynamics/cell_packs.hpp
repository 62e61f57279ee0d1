#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "dynamics/block_state.hpp"
#include "dynamics/pack.hpp"

// How kernels of hexahedra read a block's nodes and write their forces, a register of
// cells at a time: included, like pack.hpp, by files compiled once per instruction set.
namespace springcheck::dynamics::SPRINGCHECK_PATH {

/// A vector of each corner of `width` cells; corner x + 2 y + 4 z as in GridCell.
template <class Real>
using CornerPacks = std::array<std::array<Pack<Real>, 3>, 8>;

/// Calls cell_forces(number of the first cell, displacements, forces) for the cells of a
/// block of a grid and adds the forces that it writes to the nodes. It is called for
/// every slot, and must write zeros where no cell is; displacements are finite there.
///
/// Cells in a row are neighbours: the forces on their far corners are summed one lane off
/// those on their near ones, and those of a register's last cell wait for the next.
template <class Real, class CellForces>
[[gnu::always_inline]] inline void for_each_grid_cell_pack(
    std::size_t row, std::size_t layer, const BlockArrays<Real>& arrays,
    const CellForces& cell_forces) {
  const std::array<std::size_t, 4> rows{0, row, layer, layer + row};
  std::array<std::array<Pack<Real>, 3>, 4> far{};
  for (std::size_t at = 0; at < arrays.slots; at += width<Real>) {
    CornerPacks<Real> u, f;
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t i = 0; i < 3; ++i) {
        u[2 * r][i] = load(arrays.displacement[i] + at + rows[r]);
        u[2 * r + 1][i] = load(arrays.displacement[i] + at + rows[r] + 1);
      }
    cell_forces(at, u, f);
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t i = 0; i < 3; ++i) {
        Real* const to = arrays.force[i] + at + rows[r];
        store(to,
              load(to) + (f[2 * r][i] + one_earlier<Real>(far[r][i], f[2 * r + 1][i])));
        far[r][i] = f[2 * r + 1][i];
      }
  }
  // No cell begins at the last slot: nothing waits.
}

/// The same for a block without a grid: corners are read, and forces added, lane by lane
/// in the order of the cells. Cells beyond the last have the corners of some cell.
template <class Real, class CellForces>
[[gnu::always_inline]] inline void for_each_free_cell_pack(
    std::span<const std::array<std::uint32_t, 8>> corners,
    const BlockArrays<Real>& arrays, const CellForces& cell_forces) {
  for (std::size_t first = 0; first < corners.size(); first += width<Real>) {
    CornerPacks<Real> u, f;
    alignas(register_bytes) Real lanes[8][3][width<Real>];
    for (std::size_t lane = 0; lane < width<Real>; ++lane)
      for (std::size_t c = 0; c < 8; ++c)
        for (std::size_t i = 0; i < 3; ++i)
          lanes[c][i][lane] = arrays.displacement[i][corners[first + lane][c]];
    for (std::size_t c = 0; c < 8; ++c)
      for (std::size_t i = 0; i < 3; ++i) u[c][i] = load(lanes[c][i]);
    cell_forces(first, u, f);
    for (std::size_t c = 0; c < 8; ++c)
      for (std::size_t i = 0; i < 3; ++i) store(lanes[c][i], f[c][i]);
    for (std::size_t lane = 0; lane < width<Real>; ++lane)
      for (std::size_t c = 0; c < 8; ++c)
        for (std::size_t i = 0; i < 3; ++i)
          arrays.force[i][corners[first + lane][c]] += lanes[c][i][lane];
  }
}

}  // namespace springcheck::dynamics::SPRINGCHECK_PATH
