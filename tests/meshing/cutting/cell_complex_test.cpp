#include "meshing/cutting/cell_complex.hpp"

#include <boost/test/unit_test.hpp>
#include <map>

#include "meshing/generators/generate_block.hpp"
#include "tests/meshing/cutting/random_cuts.hpp"
#include "tests/meshing/cutting/three_map.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(cell_complex_test)

namespace {

/// Whether the complex has the same node at corners exactly where the map has the same
/// vertex.
bool agree(const CellComplex& cells, ThreeMap& map) {
  std::map<const void*, NodeIndex> nodes;
  std::map<NodeIndex, const void*> vertices;
  for (const ThreeMap::Corner& corner : map.corners()) {
    const NodeIndex node = cells.nodes_of(corner.face)[corner.node];
    if (nodes.emplace(corner.vertex, node).first->second != node) return false;
    if (vertices.emplace(node, corner.vertex).first->second != corner.vertex)
      return false;
  }
  return true;
}

std::size_t cells_left(const CellComplex& cells) {
  std::size_t left = 0;
  for (std::uint32_t c = 0; c < cells.cell_count(); ++c) left += !cells.is_removed(c);
  return left;
}

bool is_possible(const CellComplex& cells, const Cut& cut) {
  std::vector<CellSide> sides;
  for (const CellSide& face : cut.parted) {
    if (cells.across(face) == CellComplex::none) return false;
    sides.push_back(std::min(face, cells.other_side(face)));
  }
  std::vector<std::uint32_t> removed = cut.removed;
  std::ranges::sort(sides);
  std::ranges::sort(removed);
  return std::ranges::adjacent_find(sides) == sides.end() &&
         std::ranges::adjacent_find(removed) == removed.end() &&
         removed.size() < cells_left(cells);
}

/// All that the complex says of itself must fit together.
void check_consistent(const CellComplex& cells) {
  std::size_t corners = 0;
  for (std::uint32_t c = 0; c < cells.cell_count(); ++c) {
    corners += cells.nodes_of(c).size();
    for (const NodeIndex node : cells.nodes_of(c))
      BOOST_TEST_REQUIRE(std::ranges::count(cells.cells_at(node), c) == 1);
    for (std::uint8_t f = 0; f < cells.face_count(c); ++f)
      if (cells.across({c, f}) != CellComplex::none)
        BOOST_TEST_REQUIRE(cells.across(cells.other_side({c, f})) == c);
  }
  std::size_t at_nodes = 0;
  for (NodeIndex n = 0; n < cells.node_count(); ++n) {
    BOOST_TEST_REQUIRE(std::ranges::is_sorted(cells.cells_at(n)));
    at_nodes += cells.cells_at(n).size();
  }
  BOOST_TEST_REQUIRE(at_nodes == corners);
}

}  // namespace

// Two cells of a row of three, a face between them.
BOOST_AUTO_TEST_CASE(face_of_two_cells_parts_them) {
  CellComplex cells(generate_block({.size = {3, 1, 1}, .cells = {3, 1, 1}}));
  BOOST_TEST(cells.node_count() == 16);
  std::uint8_t f = 0;
  while (cells.across({0, f}) != 1) ++f;
  const FaceNodes before = cells.nodes_of(CellSide{0, f});
  BOOST_TEST((cells.face_with(before) == CellSide{0, f}));
  const CellSide other = cells.other_side({0, f});
  BOOST_TEST(other.cell == 1);

  cells.part(std::vector{other});
  BOOST_TEST(cells.node_count() == 20);
  BOOST_TEST(cells.across({0, f}) == CellComplex::none);
  BOOST_TEST(cells.across(other) == CellComplex::none);
  BOOST_TEST((cells.nodes_of(CellSide{0, f}) == before));  // the lowest cell keeps them
  for (const NodeIndex node : cells.nodes_of(other)) {
    BOOST_TEST(node >= 16);
    BOOST_TEST(std::ranges::count(before, cells.origin(node)) == 1);
  }
  check_consistent(cells);
}

// Around the edge in the middle of two by two cells, two that only touch there stay.
BOOST_AUTO_TEST_CASE(cells_that_touch_along_an_edge_part) {
  CellComplex cells(generate_block({.size = {2, 2, 1}, .cells = {2, 2, 1}}));
  BOOST_TEST(cells.node_count() == 18);
  cells.remove(std::vector<std::uint32_t>{1, 2});
  BOOST_TEST(cells.is_removed(1));
  BOOST_TEST(cells.nodes_of(1).size() == 0);
  BOOST_TEST(cells.node_count() == 20);
  for (const NodeIndex node : cells.nodes_of(0))
    BOOST_TEST(std::ranges::count(cells.nodes_of(3), node) == 0);
  check_consistent(cells);
}

BOOST_AUTO_TEST_CASE(slit_opens_but_at_its_tip) {
  // Cells 0, 1, 2 of the lower row below 3, 4, 5: the slit goes from the left to the
  // middle cell's right side.
  CellComplex cells(generate_block({.size = {3, 1, 2}, .cells = {3, 1, 2}}));
  std::vector<CellSide> slit;
  for (const std::uint32_t c : {0U, 1U})
    for (std::uint8_t f = 0; f < 6; ++f)
      if (cells.across({c, f}) == c + 3) slit.push_back({c, f});
  const std::size_t before = cells.node_count();
  cells.part(slit);
  BOOST_TEST(cells.node_count() == before + 4);  // two columns of two; the tip holds
  check_consistent(cells);
}

// Referee: CGAL's combinatorial map, with its own rule of what a vertex is.
BOOST_AUTO_TEST_CASE(thousand_random_cuts_part_as_a_3_map) {
  std::size_t done = 0, copies = 0;
  for (unsigned seed = 1; done < 1000; ++seed) {
    const Mesh body = random_body(seed);
    CellComplex cells(body);
    ThreeMap map(cells);
    std::mt19937 random(seed);
    BOOST_TEST_REQUIRE(agree(cells, map), "seed " << seed);
    for (int i = 0; i < 12; ++i) {
      const Cut cut = random_cut(cells, random);
      if (!is_possible(cells, cut)) continue;
      cells.part(cut.parted);
      cells.remove(cut.removed);
      map.cut(cut);
      BOOST_TEST_REQUIRE(agree(cells, map), "seed " << seed << ", cut " << i);
      check_consistent(cells);
      ++done;
    }
    copies += cells.node_count() - body.nodes().size();
  }
  BOOST_TEST(copies > 2000);  // the cuts part much
}

BOOST_AUTO_TEST_SUITE_END()
