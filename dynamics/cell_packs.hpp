#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "dynamics/block_state.hpp"
#include "dynamics/ghosts.hpp"
#include "dynamics/pack.hpp"

// How kernels of hexahedra read a block's nodes and write their forces, a register of
// cells at a time: included, like pack.hpp, by files compiled once per instruction set.
namespace springcheck::dynamics::SPRINGCHECK_PATH {

/// A number of each corner of `width` cells; corner x + 2 y + 4 z as in GridCell.
template <class Real>
using CornerPacks = std::array<Pack<Real>, 8>;

/// Reads and writes `width` cells of a grid, of one row of a block's lanes. Cells of the
/// next row share the far corners: what acts there waits in registers until it is
/// reached.
template <class Real>
class GridCells {
 public:
  GridCells(std::size_t row, std::size_t layer, const BlockArrays<Real>& arrays)
      : arrays_(arrays),
        to_{0, row * width<Real>, layer * width<Real>, (layer + row) * width<Real>} {
    fill_ghosts(arrays_, arrays_.displacement);
  }

  void go_to(std::size_t cell) { at_ = cell; }

  /// The displacements' component i at the corners.
  [[gnu::always_inline]] CornerPacks<Real> displacements(std::size_t i) const {
    const Real* const from = arrays_.displacement[i] + at_;
    CornerPacks<Real> u;
    for (std::size_t r = 0; r < 4; ++r) {
      u[2 * r] = load(from + to_[r]);
      u[2 * r + 1] = load(from + to_[r] + width<Real>);
    }
    return u;
  }

  /// Adds component i of forces on the corners; to be called once for each i.
  [[gnu::always_inline]] void add_forces(std::size_t i, const CornerPacks<Real>& f) {
    for (std::size_t r = 0; r < 4; ++r) {
      add(arrays_.force[i] + at_ + to_[r], f[2 * r] + waiting_[r][i]);
      waiting_[r][i] = f[2 * r + 1];
    }
  }

  /// Adds what waits behind the last row.
  void finish() {
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t i = 0; i < 3; ++i)
        add(arrays_.force[i] + at_ + to_[r] + width<Real>, waiting_[r][i]);
    fold_ghosts(arrays_, arrays_.force);
  }

 private:
  static void add(Real* to, Pack<Real> values) { store(to, load(to) + values); }

  BlockArrays<Real> arrays_;
  std::array<std::size_t, 4> to_;  // elements to the corners without a step along the row
  std::size_t at_ = 0;
  std::array<std::array<Pack<Real>, 3>, 4> waiting_{};
};

/// The same of a block without a grid: corners, elements of the arrays, are read, and
/// forces added, lane by lane in the order of the cells.
template <class Real>
class FreeCells {
 public:
  FreeCells(std::span<const std::array<std::uint32_t, 8>> corners,
            const BlockArrays<Real>& arrays)
      : arrays_(arrays), corners_(corners.data()) {}

  void go_to(std::size_t cell) { here_ = corners_ + cell; }

  [[gnu::always_inline]] CornerPacks<Real> displacements(std::size_t i) const {
    CornerPacks<Real> u;
    for (std::size_t lane = 0; lane < width<Real>; ++lane)
      for (std::size_t c = 0; c < 8; ++c)
        u[c][lane] = arrays_.displacement[i][here_[lane][c]];
    return u;
  }

  [[gnu::always_inline]] void add_forces(std::size_t i, const CornerPacks<Real>& f) {
    for (std::size_t lane = 0; lane < width<Real>; ++lane)
      for (std::size_t c = 0; c < 8; ++c) arrays_.force[i][here_[lane][c]] += f[c][lane];
  }

  void finish() {}

 private:
  BlockArrays<Real> arrays_;
  const std::array<std::uint32_t, 8>* corners_;
  const std::array<std::uint32_t, 8>* here_ = corners_;
};

/// Calls cell_forces(number of the first cell, cells) for a block's cells, a register of
/// them at a time. In a grid a cell's number is the element of its corner 0; it is called
/// for every one, and must add zeros where no cell is; displacements are finite there.
/// Without a grid, cells beyond the last have the corners of some cell, and likewise.
template <class Cells, class CellForces>
[[gnu::always_inline]] inline void for_each_cell_pack(Cells cells, std::size_t lanes,
                                                      std::size_t count,
                                                      const CellForces& cell_forces) {
  for (std::size_t cell = 0; cell < count; cell += lanes) {
    cells.go_to(cell);
    cell_forces(cell, cells);
  }
  cells.finish();
}

}  // namespace springcheck::dynamics::SPRINGCHECK_PATH
