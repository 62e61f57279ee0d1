#include "dynamics/blocks/blocks.hpp"

#include <boost/test/unit_test.hpp>
#include <map>
#include <set>

// The path of no special instructions is what the compiler makes here too.
#define SPRINGCHECK_PATH portable
#include "dynamics/blocks/block_state.hpp"
#include "dynamics/blocks/ghosts.hpp"
#include "dynamics/blocks/shared_nodes.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/dynamics/blocks/shuffled_cells.hpp"

namespace springcheck::dynamics {  // the mesh generators have a Block too

BOOST_AUTO_TEST_SUITE(blocks_test)

namespace {

/// Every cell is in one block, with its corners where `corners_of` has them; every node
/// is in a block, once in each; lists are of whole registers.
template <class CornersOf>
void check_blocks(const Mesh& mesh, const std::vector<Block>& blocks,
                  const CornersOf& corners_of) {
  std::vector<int> times_cell(mesh.cells().size(), 0);
  std::vector<bool> has_node(mesh.nodes().size(), false);
  bool corners_right = true, once = true, whole = true;
  for (const Block& block : blocks) {
    whole = whole && block.nodes.size() % block_granularity == 0 &&
            block.cells.size() % block_granularity == 0;
    std::set<NodeIndex> nodes;
    for (const NodeIndex node : block.nodes) {
      if (node == no_node) continue;
      has_node[node] = true;
      once = once && nodes.insert(node).second;
    }
    for (std::size_t cell = 0; cell < block.cells.size(); ++cell) {
      if (block.cells[cell] == no_cell) continue;
      ++times_cell[block.cells[cell]];
      std::set<NodeIndex> found;
      for (const std::uint32_t slot : block.corner_slots(cell))
        found.insert(block.nodes.at(slot));
      corners_right = corners_right && found == corners_of(block.cells[cell]);
    }
  }
  BOOST_TEST(std::ranges::count(times_cell, 1) == std::ssize(times_cell));
  BOOST_TEST(std::ranges::count(has_node, true) == std::ssize(has_node));
  BOOST_TEST(corners_right);
  BOOST_TEST(once);
  BOOST_TEST(whole);
}

void check_blocks(const Mesh& mesh, const std::vector<Block>& blocks) {
  check_blocks(mesh, blocks, [&](std::uint32_t c) {
    return std::set<NodeIndex>(mesh.cells()[c].begin(), mesh.cells()[c].end());
  });
}

/// All copies of a node, as (block, slot), are what each copy lists, in blocks' order.
void check_shared_nodes(const std::vector<Block>& blocks) {
  std::map<NodeIndex, std::vector<std::pair<std::size_t, std::uint32_t>>> copies_of;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::uint32_t slot = 0; slot < blocks[b].nodes.size(); ++slot)
      if (blocks[b].nodes[slot] != no_node)
        copies_of[blocks[b].nodes[slot]].emplace_back(b, slot);
  const SharedNodes shared = shared_nodes(blocks);
  std::vector<std::pair<std::size_t, std::uint32_t>> entries;  // by their number
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    BOOST_TEST(shared.first_entry[b] == entries.size());
    for (const std::uint32_t slot : shared.slots[b]) entries.emplace_back(b, slot);
  }
  BOOST_TEST(shared.entries == entries.size());
  std::size_t expected = 0;
  for (const auto& [node, copies] : copies_of)
    if (copies.size() > 1) expected += copies.size();
  BOOST_TEST(entries.size() == expected);
  bool all_right = true;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::size_t n = 0; n < shared.slots[b].size(); ++n) {
      std::vector<std::pair<std::size_t, std::uint32_t>> found;
      for (const std::uint32_t entry : shared.copies(b, n))
        found.push_back(entries[entry]);
      all_right = all_right && found == copies_of[blocks[b].nodes[shared.slots[b][n]]];
    }
  BOOST_TEST(all_right);
}

Mesh random_subset() {
  return shuffled_cells({even(21, 1), even(19, 1), even(17, 1)}, .5, 1);
}

/// A block of a grid of 5 x 4 x 9 cells, some of which are missing.
Block holey_block() {
  const Mesh mesh = shuffled_cells({even(5, 1), even(4, 1), even(9, 1)}, .8, 2);
  const std::vector<Block> blocks = grid_blocks(grid_of(mesh).value());
  return *std::ranges::max_element(blocks, {},
                                   [](const Block& b) { return b.nodes.size(); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_cell_is_in_one_block_and_every_node_in_some) {
  const Mesh cube = generate_block({.size = {1, 1, 1}, .cells = {20, 20, 20}}),
             beam = generate_block({.size = {1, 1, 50}, .cells = {3, 3, 400}}),
             scattered = random_subset(),
             sparse = shuffled_cells({even(15, 1), even(15, 1), even(15, 1)}, .3, 3);
  for (const Mesh* mesh : {&cube, &beam, &scattered, &sparse}) {
    for (const auto& blocks : {grid_blocks(grid_of(*mesh).value()), free_blocks(*mesh)}) {
      BOOST_TEST(blocks.size() > 1U);
      check_blocks(*mesh, blocks);
      check_shared_nodes(blocks);
    }
  }
  const Mesh one = generate_block({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  check_blocks(one, grid_blocks(grid_of(one).value()));
  check_blocks(one, free_blocks(one));
}

// A cell's corners are a step along rows, layers and both apart, whichever axis is which:
// neighbours in a block are a register apart.
BOOST_AUTO_TEST_CASE(slots_of_a_grid_are_right_handed) {
  for (const std::array<int, 3>& cells :
       {std::array{9, 4, 3}, std::array{3, 9, 4}, std::array{4, 3, 9}}) {
    const Mesh mesh = generate_block(
        {.size = {cells[0] + 0., cells[1] + 0., cells[2] + 0.}, .cells = cells});
    const std::vector<Block> blocks = grid_blocks(grid_of(mesh).value());
    BOOST_TEST_REQUIRE(blocks.size() == 1U);
    BOOST_TEST(blocks[0].row * (blocks[0].layer / blocks[0].row) == blocks[0].layer);
    BOOST_TEST(blocks[0].layer == 20U);  // the smallest there is
    for (std::size_t cell = 0; cell < blocks[0].cells.size(); ++cell) {
      if (blocks[0].cells[cell] == no_cell) continue;
      const auto slots = blocks[0].corner_slots(cell);
      const auto edge = [&](std::size_t corner) {
        return Vector3(mesh.nodes()[blocks[0].nodes[slots[corner]]] -
                       mesh.nodes()[blocks[0].nodes[slots[0]]]);
      };
      BOOST_TEST(edge(1).dot(edge(2).cross(edge(4))) == 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(every_slot_has_an_element_of_its_own) {
  const Block block = holey_block();
  for (const std::size_t lanes : {1U, 2U, 4U, 8U, 16U}) {
    const BlockState<float> state(block, lanes);
    std::set<std::size_t> elements;
    for (std::size_t slot = 0; slot < block.nodes.size(); ++slot)
      elements.insert(state.arrays().element(slot));
    BOOST_TEST(elements.size() == block.nodes.size());
    BOOST_TEST(*elements.rbegin() == block.nodes.size() - 1);
  }
}

// A step of d slots is one of d rows from every lane, the last rows' into the ghosts.
BOOST_AUTO_TEST_CASE(ghosts_are_the_next_lanes_slots) {
  const Block block = holey_block();
  constexpr std::size_t lanes = portable::width<double>;
  BlockState<double> state(block, lanes);
  const BlockArrays<double>& arrays = state.arrays();
  const std::size_t slots = block.nodes.size();
  double* const u = arrays.displacement[0];
  for (std::size_t slot = 0; slot < slots; ++slot)
    u[arrays.element(slot)] = static_cast<double>(slot);
  portable::fill_ghosts(arrays, arrays.displacement);
  std::size_t wrong = 0;
  for (std::size_t d = 0; d <= block.layer + block.row + 1; ++d)
    for (std::size_t slot = 0; slot + d < slots; ++slot)
      if (u[arrays.element(slot) + d * lanes] != static_cast<double>(slot + d)) ++wrong;
  BOOST_TEST(wrong == 0U);
}

// What every slot gives to the one d further on arrives there, and nothing else: whole
// numbers, so that sums are exact.
BOOST_AUTO_TEST_CASE(what_is_done_to_ghosts_reaches_their_originals) {
  const Block block = holey_block();
  constexpr std::size_t lanes = portable::width<double>;
  const std::size_t slots = block.nodes.size();
  for (std::size_t d = 1; d <= block.layer + block.row + 1; ++d) {
    BlockState<double> state(block, lanes);
    const BlockArrays<double>& arrays = state.arrays();
    for (std::size_t slot = 0; slot + d < slots; ++slot)
      arrays.force[1][arrays.element(slot) + d * lanes] += static_cast<double>(slot + 1);
    portable::fold_ghosts(arrays, arrays.force);
    std::size_t wrong = 0;
    for (std::size_t slot = 0; slot < slots; ++slot)
      if (arrays.force[1][arrays.element(slot)] !=
          (slot >= d ? static_cast<double>(slot - d + 1) : 0))
        ++wrong;
    BOOST_TEST(wrong == 0U, d);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace springcheck::dynamics
