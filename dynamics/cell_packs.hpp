#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "dynamics/block_state.hpp"
#include "dynamics/pack.hpp"

// How kernels of hexahedra read a block's nodes and write their forces, a register of
// cells at a time: included, like pack.hpp, by files compiled once per instruction set.
namespace springcheck::dynamics::SPRINGCHECK_PATH {

/// A number of each corner of `width` cells; corner x + 2 y + 4 z as in GridCell.
template <class Real>
using CornerPacks = std::array<Pack<Real>, 8>;

/// Reads and writes `width` cells in a row of a grid. Neighbours share corners: forces on
/// far corners are summed one lane off those on near ones, and those of the last cell
/// wait for the next register.
template <class Real>
class GridCells {
 public:
  GridCells(std::size_t row, std::size_t layer, const BlockArrays<Real>& arrays)
      : rows_{0, row, layer, layer + row},
        displacement_(arrays.displacement),
        force_(arrays.force) {}

  void go_to(std::size_t cell) { at_ = cell; }

  /// The displacements' component i at the corners.
  [[gnu::always_inline]] CornerPacks<Real> displacements(std::size_t i) const {
    const Real* const from = displacement_[i] + at_;
    CornerPacks<Real> u;
    for (std::size_t r = 0; r < 4; ++r) {
      u[2 * r] = load(from + rows_[r]);
      u[2 * r + 1] = load(from + rows_[r] + 1);
    }
    return u;
  }

  /// Adds component i of forces on the corners; to be called once for each i.
  [[gnu::always_inline]] void add_forces(std::size_t i, const CornerPacks<Real>& f) {
    for (std::size_t r = 0; r < 4; ++r) {
      Real* const to = force_[i] + at_ + rows_[r];
      store(to, load(to) + (f[2 * r] + one_earlier<Real>(waiting_[r][i], f[2 * r + 1])));
      waiting_[r][i] = f[2 * r + 1];
    }
  }

 private:
  std::array<std::size_t, 4> rows_;
  std::array<Real*, 3> displacement_, force_;
  std::size_t at_ = 0;
  std::array<std::array<Pack<Real>, 3>, 4> waiting_{};
};

/// The same of a block without a grid: corners are read, and forces added, lane by lane
/// in the order of the cells.
template <class Real>
class FreeCells {
 public:
  FreeCells(std::span<const std::array<std::uint32_t, 8>> corners,
            const BlockArrays<Real>& arrays)
      : corners_(corners.data()),
        displacement_(arrays.displacement),
        force_(arrays.force) {}

  void go_to(std::size_t cell) { here_ = corners_ + cell; }

  [[gnu::always_inline]] CornerPacks<Real> displacements(std::size_t i) const {
    CornerPacks<Real> u;
    for (std::size_t lane = 0; lane < width<Real>; ++lane)
      for (std::size_t c = 0; c < 8; ++c) u[c][lane] = displacement_[i][here_[lane][c]];
    return u;
  }

  [[gnu::always_inline]] void add_forces(std::size_t i, const CornerPacks<Real>& f) {
    for (std::size_t lane = 0; lane < width<Real>; ++lane)
      for (std::size_t c = 0; c < 8; ++c) force_[i][here_[lane][c]] += f[c][lane];
  }

 private:
  const std::array<std::uint32_t, 8>* corners_;
  const std::array<std::uint32_t, 8>* here_ = corners_;
  std::array<Real*, 3> displacement_, force_;
};

/// Calls cell_forces(number of the first cell, cells) for a block's cells, a register of
/// them at a time. In a grid it is called for every slot, and must add zeros where no
/// cell is; displacements are finite there. Without one, cells beyond the last have the
/// corners of some cell, and likewise.
template <class Real, class Cells, class CellForces>
[[gnu::always_inline]] inline void for_each_cell_pack(Cells cells, std::size_t count,
                                                      const CellForces& cell_forces) {
  for (std::size_t cell = 0; cell < count; cell += width<Real>) {
    cells.go_to(cell);
    cell_forces(cell, cells);
  }
}

}  // namespace springcheck::dynamics::SPRINGCHECK_PATH
