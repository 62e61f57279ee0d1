#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "dynamics/blocks/block_cells.hpp"
#include "dynamics/blocks/block_state.hpp"
#include "dynamics/blocks/ghosts.hpp"
#include "dynamics/blocks/pack.hpp"

// How kernels of hexahedra read a block's nodes and write their forces, a register of
// cells at a time: included, like pack.hpp, by files compiled once per instruction set.
namespace springcheck::dynamics::SPRINGCHECK_PATH {

/// A number of each corner of `width` cells; corner x + 2 y + 4 z as in GridCell.
template <class Real>
using CornerPacks = std::array<Pack<Real>, 8>;

/// The arrays of a block that the cells read and those that they add to.
template <class Real, std::size_t read, std::size_t written>
struct CellFields {
  std::array<Real*, read> from;
  std::array<Real*, written> to;
};

/// Reads and writes `width` cells of a grid, of one row of a block's lanes. Cells of the
/// next row share the far corners: what acts there waits in registers until it is
/// reached.
template <class Real, std::size_t read, std::size_t written>
class GridCells {
 public:
  GridCells(std::size_t row, std::size_t layer, const BlockArrays<Real>& arrays,
            const CellFields<Real, read, written>& fields)
      : arrays_(arrays),
        fields_(fields),
        to_{0, row * width<Real>, layer * width<Real>, (layer + row) * width<Real>} {
    fill_ghosts(arrays_, fields_.from);
  }

  void go_to(std::size_t cell) { at_ = cell; }

  /// Field i of those read, at the corners.
  [[gnu::always_inline]] CornerPacks<Real> at_corners(std::size_t i) const {
    const Real* const from = fields_.from[i] + at_;
    CornerPacks<Real> u;
    for (std::size_t r = 0; r < 4; ++r) {
      u[2 * r] = load(from + to_[r]);
      u[2 * r + 1] = load(from + to_[r] + width<Real>);
    }
    return u;
  }

  /// Adds to field i of those written; to be called once for each i.
  [[gnu::always_inline]] void add_at_corners(std::size_t i, const CornerPacks<Real>& f) {
    for (std::size_t r = 0; r < 4; ++r) {
      add(fields_.to[i] + at_ + to_[r], f[2 * r] + waiting_[r][i]);
      waiting_[r][i] = f[2 * r + 1];
    }
  }

  /// Adds what waits behind the last row.
  void finish() {
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t i = 0; i < written; ++i)
        add(fields_.to[i] + at_ + to_[r] + width<Real>, waiting_[r][i]);
    fold_ghosts(arrays_, fields_.to);
  }

 private:
  static void add(Real* to, Pack<Real> values) { store(to, load(to) + values); }

  BlockArrays<Real> arrays_;
  CellFields<Real, read, written> fields_;
  std::array<std::size_t, 4> to_;  // elements to the corners without a step along the row
  std::size_t at_ = 0;
  std::array<std::array<Pack<Real>, written>, 4> waiting_{};
};

/// The same of a block without a grid: corners, elements of the arrays, are read, and
/// added to, lane by lane in the order of the cells.
template <class Real, std::size_t read, std::size_t written>
class FreeCells {
 public:
  FreeCells(std::span<const std::array<std::uint32_t, 8>> corners,
            const CellFields<Real, read, written>& fields)
      : fields_(fields), corners_(corners.data()) {}

  void go_to(std::size_t cell) { here_ = corners_ + cell; }

  [[gnu::always_inline]] CornerPacks<Real> at_corners(std::size_t i) const {
    CornerPacks<Real> u;
    for (std::size_t lane = 0; lane < width<Real>; ++lane)
      for (std::size_t c = 0; c < 8; ++c) u[c][lane] = fields_.from[i][here_[lane][c]];
    return u;
  }

  [[gnu::always_inline]] void add_at_corners(std::size_t i, const CornerPacks<Real>& f) {
    for (std::size_t lane = 0; lane < width<Real>; ++lane)
      for (std::size_t c = 0; c < 8; ++c) fields_.to[i][here_[lane][c]] += f[c][lane];
  }

  void finish() {}

 private:
  CellFields<Real, read, written> fields_;
  const std::array<std::uint32_t, 8>* corners_;
  const std::array<std::uint32_t, 8>* here_ = corners_;
};

template <class Real, class Cells, class Visit>
[[gnu::always_inline]] inline void for_each_cell_pack(Cells cells, std::size_t count,
                                                      const Visit& visit) {
  for (std::size_t cell = 0; cell < count; cell += width<Real>) {
    cells.go_to(cell);
    visit(cell, cells);
  }
  cells.finish();
}

/// Calls visit(number of the first cell, cells) for a block's cells, a register of them
/// at a time. In a grid a cell's number is the element of its corner 0; visit is called
/// for every one, and must add zeros where no cell is; the fields are finite there.
/// Without a grid, cells beyond the last have the corners of some cell, and visit must
/// add zeros for them too.
template <bool in_grid, class Real, std::size_t read, std::size_t written, class Visit>
inline void for_each_cell_pack(const BlockCells& cells, const BlockArrays<Real>& arrays,
                               const CellFields<Real, read, written>& fields,
                               const Visit& visit) {
  if constexpr (in_grid)
    for_each_cell_pack<Real>(
        GridCells<Real, read, written>(cells.row, cells.layer, arrays, fields),
        cells.count, visit);
  else
    for_each_cell_pack<Real>(FreeCells<Real, read, written>(cells.corners, fields),
                             cells.count, visit);
}

}  // namespace springcheck::dynamics::SPRINGCHECK_PATH
