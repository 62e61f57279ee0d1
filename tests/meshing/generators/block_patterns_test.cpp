#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>

#include "meshing/cell_geometry.hpp"
#include "meshing/generators/generate_block.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(block_patterns_test)

namespace {

constexpr std::array grid_patterns{CellPattern::hexahedron,    CellPattern::tetrahedron,
                                   CellPattern::prism,         CellPattern::pyramid,
                                   CellPattern::mixed,         CellPattern::tetrahedron_5,
                                   CellPattern::tetrahedron_12};

Block block(CellPattern pattern, std::array<int, 3> cells) {
  return {.size = {0.3, 0.2, 0.7}, .cells = cells, .pattern = pattern};
}

/// Cells of each type: tetrahedra, pyramids, prisms, hexahedra.
std::array<std::size_t, 4> counts(const Mesh& mesh) {
  return {mesh.count(CellType::tetrahedron), mesh.count(CellType::pyramid),
          mesh.count(CellType::prism), mesh.count(CellType::hexahedron)};
}

/// Smallest corner Jacobian over the product of the three edge lengths there: 1 for a
/// cube.
double smallest_corner_sine(const Mesh& mesh) {
  double smallest = 1;
  for (const CellNodes& cell : mesh.cells()) {
    const CornerPositions x = corners(cell, mesh.nodes());
    // All corners count, those of tetrahedra too.
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      std::vector<Vector3> away;
      for (const auto& [a, b] : edges(type_of(cell)))
        if (static_cast<Eigen::Index>(a) == i || static_cast<Eigen::Index>(b) == i)
          away.push_back((x.col(static_cast<Eigen::Index>(a + b) - i) - x.col(i)));
      if (away.size() != 3) continue;  // a pyramid's apex
      const double jacobian = std::abs(away[0].dot(away[1].cross(away[2])));
      smallest = std::min(smallest,
                          jacobian / (away[0].norm() * away[1].norm() * away[2].norm()));
    }
  }
  return smallest;
}

}  // namespace

// A face that two cells cut differently would be a boundary face inside the block.
BOOST_AUTO_TEST_CASE(cells_fit_together_and_the_regions_are_the_whole_surface) {
  for (const CellPattern pattern : grid_patterns)
    for (const auto& cells : {std::array{1, 1, 1}, {1, 2, 3}, {2, 2, 2}, {5, 3, 4}}) {
      const Mesh mesh = generate_block(block(pattern, cells));
      BOOST_TEST_CONTEXT(mesh.source()) {
        std::multiset<FaceNodes> outside, in_regions;
        for (const FaceNodes& face : mesh.boundary().faces)
          outside.insert(ascending(face));
        BOOST_TEST(mesh.regions().size() == 6U);
        for (const auto& [name, region] : mesh.regions())
          for (const FaceNodes& face : region.faces) in_regions.insert(ascending(face));
        BOOST_TEST((outside == in_regions));
      }
    }
}

// The tolerance is round-off of sums of up to 720 cells.
BOOST_AUTO_TEST_CASE(cells_fill_the_block, *boost::unit_test::tolerance(1e-13)) {
  for (const CellPattern pattern : grid_patterns)
    BOOST_TEST(generate_block(block(pattern, {5, 3, 4})).volume() == 0.3 * 0.2 * 0.7);
}

BOOST_AUTO_TEST_CASE(grid_nodes_come_first_and_centres_behind) {
  const Mesh grid = generate_block(block(CellPattern::hexahedron, {3, 2, 4}));
  for (const CellPattern pattern : grid_patterns) {
    const Mesh mesh = generate_block(block(pattern, {3, 2, 4}));
    BOOST_TEST_REQUIRE(mesh.nodes().size() >= 60U);
    BOOST_TEST(
        std::equal(grid.nodes().begin(), grid.nodes().end(), mesh.nodes().begin()));
  }
  const Mesh pyramids = generate_block(block(CellPattern::pyramid, {3, 2, 4}));
  for (std::size_t c = 0; c < 24; ++c) {
    const Vector3 centre = corners(grid.cells()[c], grid.nodes()).rowwise().mean();
    // The centre is the mean of eight corners, to round-off.
    BOOST_TEST((pyramids.nodes()[60 + c] - centre).norm() < 1e-15);
    for (std::size_t side = 0; side < 6; ++side)
      BOOST_TEST(pyramids.cells()[6 * c + side][4] == 60 + c);
  }
}

BOOST_AUTO_TEST_CASE(each_pattern_has_its_cells) {
  struct Expected {
    CellPattern pattern;
    std::array<std::size_t, 4> counts;
    std::size_t nodes;
  };
  for (const auto& [pattern, cells, nodes] :
       {Expected{CellPattern::hexahedron, {0, 0, 0, 24}, 60},
        {CellPattern::tetrahedron, {144, 0, 0, 0}, 60},
        {CellPattern::prism, {0, 0, 48, 0}, 60},
        {CellPattern::pyramid, {0, 144, 0, 0}, 84},
        {CellPattern::tetrahedron_5, {120, 0, 0, 0}, 60},
        {CellPattern::tetrahedron_12, {288, 0, 0, 0}, 84}}) {
    const Mesh mesh = generate_block(block(pattern, {3, 2, 4}));
    BOOST_TEST(counts(mesh) == cells, boost::test_tools::per_element());
    BOOST_TEST(mesh.nodes().size() == nodes);
  }
}

BOOST_AUTO_TEST_CASE(six_tetrahedra_are_the_same_in_each_hexahedron_three_in_each_prism) {
  const Mesh mesh = generate_block(block(CellPattern::tetrahedron, {3, 2, 4}));
  const Mesh grid = generate_block(block(CellPattern::hexahedron, {3, 2, 4}));
  const Mesh prisms = generate_block(block(CellPattern::prism, {3, 2, 4}));
  for (std::size_t c = 0; c < 144; ++c) {
    const NodeIndex first = grid.cells()[c / 6][0], first_of_all = grid.cells()[0][0];
    for (std::size_t i = 0; i < 4; ++i) {
      BOOST_TEST(mesh.cells()[c][i] - first == mesh.cells()[c % 6][i] - first_of_all);
      BOOST_TEST(std::ranges::count(prisms.cells()[c / 3], mesh.cells()[c][i]) == 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(twelve_tetrahedra_are_six_in_each_prism) {
  const Mesh mesh = generate_block(block(CellPattern::tetrahedron_12, {3, 2, 4}));
  const Mesh prisms = generate_block(block(CellPattern::prism, {3, 2, 4}));
  std::vector<int> inside(prisms.cells().size(), 0);
  for (std::size_t c = 0; c < mesh.cells().size(); ++c)
    for (const std::size_t p : {c / 12 * 2, c / 12 * 2 + 1}) {
      const auto is_corner = [&](NodeIndex node) {
        return node >= 60 || std::ranges::count(prisms.cells()[p], node) == 1;
      };
      if (std::ranges::all_of(mesh.cells()[c], is_corner)) ++inside[p];
    }
  BOOST_TEST(inside == std::vector<int>(48, 6), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(five_tetrahedra_are_mirrored_from_one_hexahedron_to_the_next) {
  const Mesh mesh = generate_block(block(CellPattern::tetrahedron_5, {2, 1, 1}));
  for (const NodeIndex node : mesh.cells()[0]) {
    const Vector3 mirrored(0.3 - mesh.nodes()[node].x(), mesh.nodes()[node].y(),
                           mesh.nodes()[node].z());
    BOOST_TEST(std::ranges::any_of(mesh.cells()[5], [&](NodeIndex other) {
      return (mesh.nodes()[other] - mirrored).norm() < 1e-15;  // 0.3 - 0.15: round-off
    }));
  }
}

BOOST_AUTO_TEST_CASE(mixed_block_has_all_four_types_wherever_it_can) {
  for (const auto& cells : {std::array{3, 1, 1},
                            {1, 3, 1},
                            {1, 1, 3},
                            {2, 2, 1},
                            {1, 2, 2},
                            {2, 2, 2},
                            {3, 3, 3},
                            {8, 7, 5}})
    for (const unsigned seed : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U}) {
      Block mixed = block(CellPattern::mixed, cells);
      mixed.seed = seed;
      const Mesh mesh = generate_block(mixed);
      for (const std::size_t count : counts(mesh)) BOOST_TEST(count > 0U, mesh.source());
    }
}

// Each type fills its share: a rule that nearly never draws one would pass all others.
BOOST_AUTO_TEST_CASE(each_type_fills_a_twentieth_of_a_mixed_block_at_least) {
  const Mesh mesh = generate_block(block(CellPattern::mixed, {12, 12, 12}));
  std::array<double, 4> volumes{};
  for (std::size_t c = 0; c < mesh.cells().size(); ++c)
    volumes[static_cast<std::size_t>(type_of(mesh.cells()[c]))] += mesh.cell_volumes()[c];
  for (const double volume : volumes) BOOST_TEST(volume > mesh.volume() / 20);
}

BOOST_AUTO_TEST_CASE(mixed_block_is_as_the_seed_says) {
  Block mixed = block(CellPattern::mixed, {4, 4, 4});
  const std::string hash = generate_block(mixed).sha256();
  BOOST_TEST(generate_block(mixed).sha256() == hash);
  mixed.seed = 2;
  BOOST_TEST(generate_block(mixed).sha256() != hash);
}

// By hand on cubes: the worst corner of each type is a centre-split tetrahedron's, with
// edges 1, sqrt 2, sqrt(3/4) and Jacobian 1/2.
BOOST_AUTO_TEST_CASE(mixed_cells_have_corner_sines_of_0_41_and_up,
                     *boost::unit_test::tolerance(1e-12)) {
  const Mesh mesh = generate_block(
      {.size = {6, 6, 6}, .cells = {6, 6, 6}, .pattern = CellPattern::mixed});
  BOOST_TEST(smallest_corner_sine(mesh) == 1 / std::sqrt(6.));
}

BOOST_AUTO_TEST_SUITE_END()
