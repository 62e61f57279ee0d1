#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dynamics/blocks/block_cells.hpp"
#include "dynamics/blocks/block_state.hpp"

namespace springcheck::mss {

/// Corners, numbered as in dynamics::GridCell, of the springs against hourglasses: 4 k to
/// 4 k + 3 are the edges along direction k; 12 + 4 k to 12 + 4 k + 3 the diagonals of the
/// two faces across k, with i and j the next directions in cyclic order first those along
/// i + j, then those along i - j.
inline constexpr std::array<std::array<std::size_t, 2>, 24> affine_springs = [] {
  std::array<std::array<std::size_t, 2>, 24> springs{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t along = std::size_t{1} << k, i = std::size_t{1} << (k + 1) % 3,
                      j = std::size_t{1} << (k + 2) % 3;
    for (std::size_t n = 0; n < 4; ++n) {
      const std::size_t from = (n & 1U) * i + (n >> 1U) * j;
      springs[4 * k + n] = {from, from + along};
    }
    for (std::size_t side = 0; side < 2; ++side) {
      springs[12 + 4 * k + side] = {side * along, side * along + i + j};
      springs[12 + 4 * k + 2 + side] = {side * along + j, side * along + i};
    }
  }
  return springs;
}();

/// The cells of a block, in the precision of its kernel. With xi_k from 0 to 1 along the
/// k-th direction, constants of a cell are
///
///     alike     V; of each direction the edge X_k and then grad xi_k; k of the springs,
///               one number for those along the same vector
///     else      V; G_a of corners 1 to 7; X_a - X_0 of corners 1 to 7; k of the springs
///
/// in squared lengths k/(2 L^2) in place of k, and
/// all of them 0 where there is no cell, but for alike ones.
template <class Real>
struct AffineBlock {
  dynamics::BlockCells cells;
  // The n-th constant of a cell is constants[n] where cells are alike, and else
  // constants[n cells.count + number of the cell].
  std::vector<Real> constants{};
  std::vector<std::uint8_t> is_cell{};  // where cells are alike
  // The moduli of the icosahedron's axes and of those of the dodecahedron dual to it
  // [Pa]: mu times their weight, see Axis. In squared lengths the first is mu, and the
  // second is not read.
  Real axis_modulus, dual_axis_modulus;
  Real volume_modulus;  // kappa [Pa]; 0: without a volume correction
  // With the volume correction on nodal patches, the factor of each element that makes of
  // the nodal sum of V (det F - 1) over cells the node's part, an eighth of p_n, of a
  // cell's pressure.
  std::vector<Real> pressure_per_sum{};
  // With dashpots, c of each cell and edge [kg/s], in the order of the springs.
  std::vector<Real> dashpots{};
};

/// What a kernel is compiled for, so that it does nothing a block has no need of.
struct AffineKind {
  bool in_grid;
  bool alike;    // all cells the same parallelepiped of a grid
  bool patches;  // the volume correction on nodal patches, else on cells
  bool squared;  // by Green's strain, else by engineering strain
  bool dashpots;
};

template <class Real>
using BlockFunction = void (*)(const AffineBlock<Real>& block,
                               const dynamics::BlockArrays<Real>& arrays);

template <class Real>
struct AffineFunctions {
  BlockFunction<Real> forces;
  BlockFunction<Real> volume_sums;  // see dynamics::BlockForces
};

}  // namespace springcheck::mss
