#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dynamics/blocks/block_cells.hpp"
#include "dynamics/blocks/block_state.hpp"

namespace springcheck::fem_reference {

/// What the cells of a block have in common.
enum class CellShapes {
  boxes,            // all the same box, its edges along the axes
  parallelepipeds,  // all the same parallelepiped
  hexahedra         // nothing
};

/// What a kernel is compiled for, so that it does nothing a block has no need of.
struct HexahedronKind {
  bool one_point;  // or eight
  bool in_grid;
  CellShapes shapes;
};

/// The cells of a block, in the precision of its kernel. With i from 0 to 2 a component
/// of a vector, Y_s = sum_b phi_s(b) X_b and b_s = sum_a phi_s(a) B_a/8 (hexahedra.hpp,
/// whose modes these are), constants of a cell are
///
///     one_point     V; mu k_s/64 of the four hourglass modes; then of
///       boxes             b_s,s of the modes 1, 2, 4
///       parallelepipeds   b_s,i of the modes 1, 2, 4
///       hexahedra         Y_s,i of the hourglass modes, b_s,i of the modes 1 to 6
///     eight points  of each point, a single one where cells are alike: its volume; then
///       boxes             d xi_k/d X_k
///       parallelepipeds,
///       hexahedra         d xi_k/d X_i
///
/// row by row.
template <class Real>
struct HexahedronBlock {
  dynamics::BlockCells cells;
  // The component along each direction of the block, where the cells are boxes:
  std::array<std::size_t, 3> axes{0, 1, 2};
  // The n-th constant of a cell is constants[n] where cells are alike, and else
  // constants[n cells.count + number of the cell], 0 where there is no cell.
  std::vector<Real> constants{};
  std::vector<std::uint8_t> is_cell{};  // where cells are alike
  Real half_lambda, mu;                 // [Pa]
  std::vector<Real> drag{};             // of each element [kg/s]; empty without
};

template <class Real>
using HexahedronForces = void (*)(const HexahedronBlock<Real>& block,
                                  const dynamics::BlockArrays<Real>& arrays);

}  // namespace springcheck::fem_reference
