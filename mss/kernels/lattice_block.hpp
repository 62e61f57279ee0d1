#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dynamics/blocks/block_state.hpp"
#include "dynamics/blocks/look_up.hpp"

namespace springcheck::mss {

/// Steps (x, y, z) in a grid from a node to the one at a spring's other end. Of each pair
/// of opposite steps there is the one that leads to the later node in a block: 3 edges, 6
/// face diagonals, 4 inner diagonals.
inline constexpr std::array<std::array<int, 3>, 13> lattice_steps{{{1, 0, 0},
                                                                   {-1, 1, 0},
                                                                   {0, 1, 0},
                                                                   {1, 1, 0},
                                                                   {-1, -1, 1},
                                                                   {0, -1, 1},
                                                                   {1, -1, 1},
                                                                   {-1, 0, 1},
                                                                   {0, 0, 1},
                                                                   {1, 0, 1},
                                                                   {-1, 1, 1},
                                                                   {0, 1, 1},
                                                                   {1, 1, 1}}};

enum class SpringKind { edge, face_diagonal, inner_diagonal };

constexpr SpringKind kind_of(const std::array<int, 3>& step) {
  const int moves = (step[0] != 0) + (step[1] != 0) + (step[2] != 0);
  return moves == 1   ? SpringKind::edge
         : moves == 2 ? SpringKind::face_diagonal
                      : SpringKind::inner_diagonal;
}

/// The springs and cells of a block of a grid, in the precision of its kernel.
template <class Real>
struct LatticeBlock {
  std::size_t row, layer;   // of dynamics::Block
  std::size_t rows, lanes;  // of dynamics::BlockArrays

  // Where all cells are alike: the rest vector [m] of each step, the stiffness k of one
  // share [N/m] and k L [N]; and the mean edges of a cell.
  std::array<std::array<Real, 3>, 13> rest{};
  std::array<Real, 13> stiffness{}, tension{};
  std::array<std::array<Real, 3>, 3> fourfold_edges{};  // 4 X, 4 Y, 4 Z
  std::array<Real, 3> sixteenfold_area{};               // 16 X x Y [m^2]
  Real push_per_change{};  // -kappa/V0/4/16/64: force over 16-fold areas and 64-fold V
  // In squared lengths, where the alike cells' edges also lie along the axes: the
  // component that is along each direction of the block; a cell's edges there, with their
  // sign; for each edge 1/(32 X^2), trace over squares of fourfold edges, and -kappa
  // V0/(16 X^2), force over those edges and trace; for each step L^2, and k/(2 L^2) times
  // 0, 1, 2 ...
  std::array<std::size_t, 3> along{};
  std::array<Real, 3> box{}, trace_per_square{}, push_per_trace{};
  std::array<Real, 13> rest_square{};
  std::array<std::array<Real, dynamics::largest_look_up>, 13> stiffness_of{};
  // How many shares the spring that leaves a slot has; whether a cell is there:
  std::array<std::vector<std::uint8_t>, 13> shares{};
  std::vector<std::uint8_t> is_cell{};

  // Where the cells are not alike: X of each slot, with ghosts; k and k L of each spring,
  // in squared lengths k/(2 L^2) and k/2; and of each cell V0 and, by component and
  // corner, the gradients of F. They are 0 where there is no spring or cell.
  std::array<std::vector<Real>, 3> position{};
  std::array<std::vector<Real>, 13> stiffnesses{}, tensions{};
  std::vector<Real> cell_volumes{};
  std::array<std::array<std::vector<Real>, 8>, 3> gradients{};

  Real volume_modulus{};       // kappa [Pa]
  Real twice_damping_ratio{};  // 2 zeta

  // Lists are in the order of dynamics::BlockArrays.
  [[nodiscard]] std::size_t element(std::size_t slot) const {
    return slot % rows * lanes + slot / rows;
  }
};

/// What a kernel is compiled for, so that it does nothing a method has no need of.
struct LatticeKind {
  bool alike;    // all cells of one size and stiffness
  bool squared;  // by Green's strain, else by engineering strain
  bool face_diagonals;
  bool correction;
  bool dashpots;
};

template <class Real>
using LatticeForces = void (*)(const LatticeBlock<Real>& block,
                               const dynamics::BlockArrays<Real>& arrays);

}  // namespace springcheck::mss
