#pragma once

#include <algorithm>

#include "dynamics/blocks/block_cells.hpp"
#include "mss/kernels/lattice_block.hpp"
#include "mss/networks/network.hpp"

// The places of a network's cells and springs in blocks.
namespace springcheck::mss {

/// Whether the springs follow Green's strain, and so are in squared lengths.
inline bool is_squared(const Network& network) {
  return network.strain_measure == StrainMeasure::green;
}

/// A cell's spring where the grid has it: it leaves `slot` by lattice_steps[step].
struct PlacedSpring {
  std::size_t slot;
  std::size_t step;
  NodeIndex from, to;
  double stiffness;
  Vector3 rest;  // along the step
};

/// The place of the cell's spring between two corners, numbered as in dynamics::GridCell.
PlacedSpring placed(const dynamics::Block& block, std::size_t cell, std::size_t first,
                    std::size_t second, const CellSpring& spring);

/// Calls visit(cell number, cell of the network, corner of each of its nodes).
template <class Visit>
void for_each_cell(const Network& network, const dynamics::Block& block,
                   const Visit& visit) {
  dynamics::for_each_cell(block, [&](std::size_t cell, const auto& slots) {
    const auto nodes = network.cells.nodes(block.cells[cell]);
    std::array<std::size_t, 8> corner{};
    for (std::size_t c = 0; c < 8; ++c)
      corner[static_cast<std::size_t>(std::ranges::find(nodes, block.nodes[slots[c]]) -
                                      nodes.begin())] = c;
    visit(cell, block.cells[cell], corner);
  });
}

/// Calls visit(placed spring) for every spring of every cell of the block.
template <class Visit>
void for_each_placed(const Network& network, const dynamics::Block& block,
                     const Visit& visit) {
  for_each_cell(network, block,
                [&](std::size_t cell, std::uint32_t c, const auto& corner) {
                  for (const CellSpring& spring : network.cells.springs(c))
                    visit(placed(block, cell, corner[spring.ends[0]],
                                 corner[spring.ends[1]], spring));
                });
}

/// What the cells of a block have in common, if they do: the edges, as columns, and the
/// volume; and for each step the rest vector and one share's stiffness, 0 where there are
/// none.
struct CommonShape {
  std::array<Vector3, 13> rest{};
  std::array<double, 13> share{};
  Eigen::Matrix3d edges;
  double volume = 0;
  double relative_rounding = 0;
  bool alike = false;
};

/// Whether two numbers are equal but for rounding. Positions differ from those of a
/// perfect grid by their rounding; numbers that go with a length by a few times that over
/// the cells' edge, CommonShape::relative_rounding.
bool equal_but_for_rounding(double a, double b, double relative_rounding);

/// rounding: dynamics::rounding_of the rest positions.
CommonShape common_shape(const Network& network, const dynamics::Block& block,
                         double rounding);

}  // namespace springcheck::mss
