#include "meshing/generators/z_curve.hpp"

#include <boost/test/unit_test.hpp>

#include "meshing/cell_geometry.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(z_curve_test)

namespace {

/// A row of two cubes along x, numbered wildly.
MeshParts row() {
  MeshParts parts;
  for (const int x : {2, 0, 1})
    for (const auto& [y, z] : {std::pair{1, 1}, {0, 0}, {0, 1}, {1, 0}})
      parts.nodes.emplace_back(x, y, z);
  // Of each four nodes, (y, z) = (0, 0), (1, 0), (0, 1), (1, 1) are number 1, 3, 2, 0.
  parts.cells = {{9, 1, 3, 11, 10, 2, 0, 8}, {5, 9, 11, 7, 6, 10, 8, 4}};
  return parts;
}

}  // namespace

// In a box of edge 2 the first bits tell all but x = 1 from x = 2: x runs fastest there,
// as the lowest of the interleaved bits, then y.
BOOST_AUTO_TEST_CASE(nodes_follow_the_curve) {
  std::vector<Vector3> expected;
  for (const int z : {0, 1})
    for (const int y : {0, 1})
      for (const int x : {0, 1, 2}) expected.emplace_back(x, y, z);
  BOOST_TEST((along_z_curve(row()).nodes == expected));
}

// The curve does not go row by row: a quarter of the square is done before the next
// begins.
BOOST_AUTO_TEST_CASE(curve_fills_one_octant_after_the_other) {
  MeshParts square;
  for (const int y : {0, 1, 2, 3})
    for (const int x : {0, 1, 2, 3}) square.nodes.emplace_back(x, y, 0);
  const MeshParts sorted = along_z_curve(square);
  for (int n = 0; const Vector3& x : sorted.nodes) {
    BOOST_TEST((Vector3((x / 2).array().floor()) == Vector3(n / 4 % 2, n / 8, 0)));
    ++n;
  }
}

BOOST_AUTO_TEST_CASE(cells_follow_the_curve_and_keep_their_corners) {
  const MeshParts parts = row(), sorted = along_z_curve(parts);
  BOOST_TEST_REQUIRE(sorted.cells.size() == 2U);
  for (std::size_t c = 0; c < 2; ++c)
    BOOST_TEST((corners(sorted.cells[c], sorted.nodes) ==
                corners(parts.cells[1 - c], parts.nodes)));
}

BOOST_AUTO_TEST_SUITE_END()
