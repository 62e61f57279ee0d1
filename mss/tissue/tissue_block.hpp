#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/blocks/block_cells.hpp"
#include "dynamics/blocks/block_state.hpp"
#include "tissue/memory.hpp"

namespace springcheck::mss {

/// The law of tissue as its kernel needs it, see memory.hpp.
struct TissueConstants {
  struct Branch {
    double linear, hardening;  // G, B/(p+1) [Pa]
  };
  Branch elastic;
  std::vector<Branch> branches{};
  double viscosity;       // eta [Pa s]
  double bulk_ratio;      // r
  double inverse_square;  // 1/gamma_lim^2
  double exponent;        // p/2
};

/// The cells of a block. With xi_k from 0 to 1 along the k-th direction, constants of a
/// cell are
///
///     alike     V; c/S_m; grad xi_k of each direction
///     else      V; c/S_m; G_a of corners 1 to 7; of four orthonormal vectors that span
///               what is not affine the eight corners' components
///
/// (see tissue_cell.hpp), all of them 0 where there is no cell, but for alike ones.
struct TissueBlock {
  dynamics::BlockCells cells;
  // The n-th constant of a cell is constants[n] where cells are alike, and else at
  // place_in_packs:
  std::vector<double> constants{};
  std::vector<std::uint8_t> is_cell{};  // where cells are alike
  std::vector<double> memories{};       // A_1 to A_N, at place_in_packs
};

/// Numbers of a cell's memory. C'^-1 of the last step is not among them: see
/// tissue::short_memory_step.
constexpr std::size_t tissue_memory_size(std::size_t branches) {
  return 6 * branches;
}

inline constexpr std::size_t own_tissue_constants = 55;

/// The place of the n-th of so many numbers of a cell: those of a register of cells lie
/// together, each number's side by side.
constexpr std::size_t place_in_packs(std::size_t cell, std::size_t n, std::size_t size,
                                     std::size_t lanes) {
  return (cell - cell % lanes) * size + n * lanes + cell % lanes;
}

/// What a kernel is compiled for.
struct TissueKind {
  bool in_grid;
  bool alike;     // all cells the same parallelepiped of a grid
  bool advances;  // the memories, by a step
};

/// step: null unless it advances.
using TissueFunction = void (*)(const TissueConstants& constants, TissueBlock& block,
                                const tissue::MemoryStep* step,
                                const dynamics::BlockArrays<double>& arrays);

}  // namespace springcheck::mss
