#include "meshing/generators/generate_block.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "meshing/basics/input_error.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(block_test)

namespace {

// Sides and cells all different, so that mixed-up axes show.
const Block block{.size = {0.3, 0.2, 0.7}, .cells = {3, 2, 4}};

/// Number of the grid node (i, j, k), x fastest.
NodeIndex grid_node(int i, int j, int k) {
  return static_cast<NodeIndex>(i + 4 * (j + 3 * k));
}

void check_refusal(const Block& bad, const std::string& message) {
  BOOST_CHECK_EXCEPTION(generate_block(bad), InputError, [&](const InputError& error) {
    BOOST_TEST(error.what() == message);
    return true;
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(block_has_the_nodes_cells_and_volume_asked_for) {
  const Mesh mesh = generate_block(block);
  BOOST_TEST(mesh.nodes().size() == 4U * 3 * 5);
  BOOST_TEST(mesh.cells().size() == 3U * 2 * 4);
  BOOST_TEST(mesh.source() == "block 0.3 x 0.2 x 0.7 m in 3 x 2 x 4 cells");
  // Sums of 24 cells: round-off.
  BOOST_TEST(mesh.volume() == 0.3 * 0.2 * 0.7, boost::test_tools::tolerance(1e-14));
}

// Bit for bit.
BOOST_AUTO_TEST_CASE(nodes_stand_exactly_on_the_grid_in_lexicographic_order) {
  const Mesh mesh = generate_block(block);
  for (int k = 0; k <= 4; ++k)
    for (int j = 0; j <= 2; ++j)
      for (int i = 0; i <= 3; ++i) {
        const Vector3& x = mesh.nodes()[grid_node(i, j, k)];
        BOOST_TEST((x == Vector3(0.3 * i / 3, 0.2 * j / 2, 0.7 * k / 4)));
      }
}

BOOST_AUTO_TEST_CASE(cells_are_upright_and_in_lexicographic_order) {
  const Mesh mesh = generate_block(block);
  std::size_t cell = 0;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) {
        const CellNodes expected{grid_node(i, j, k),
                                 grid_node(i + 1, j, k),
                                 grid_node(i + 1, j + 1, k),
                                 grid_node(i, j + 1, k),
                                 grid_node(i, j, k + 1),
                                 grid_node(i + 1, j, k + 1),
                                 grid_node(i + 1, j + 1, k + 1),
                                 grid_node(i, j + 1, k + 1)};
        BOOST_TEST(mesh.cells()[cell++] == expected, boost::test_tools::per_element());
      }
}

BOOST_AUTO_TEST_CASE(regions_are_the_six_sides_facing_outward,
                     *boost::unit_test::tolerance(1e-14)) {
  struct Side {
    const char* name;
    Eigen::Index axis;
    double place;
    Vector3 area;  // [m^2], outward
    std::size_t faces;
  };
  const std::vector<Side> sides{
      {"bottom", 2, 0, {0, 0, -0.06}, 6}, {"top", 2, 0.7, {0, 0, 0.06}, 6},
      {"y_min", 1, 0, {0, -0.21, 0}, 12}, {"y_max", 1, 0.2, {0, 0.21, 0}, 12},
      {"x_min", 0, 0, {-0.14, 0, 0}, 8},  {"x_max", 0, 0.3, {0.14, 0, 0}, 8}};
  const Mesh mesh = generate_block(block);
  BOOST_TEST(mesh.regions().size() == sides.size());
  for (const Side& side : sides) {
    BOOST_TEST_CONTEXT(side.name) {
      const Region& region = mesh.region(side.name);
      BOOST_TEST(region.faces.size() == side.faces);
      for (const NodeIndex node : region.nodes)
        BOOST_TEST(mesh.nodes()[node][side.axis] == side.place);
      for (const FaceNodes& face : region.faces) {
        const auto& x = mesh.nodes();
        const Vector3 area = (x[face[2]] - x[face[0]]).cross(x[face[3]] - x[face[1]]) / 2;
        const Vector3 expected = side.area / static_cast<double>(side.faces);
        for (Eigen::Index i = 0; i < 3; ++i) BOOST_TEST(area[i] == expected[i]);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(same_block_twice_is_the_same_mesh) {
  BOOST_TEST(generate_block(block).sha256() == generate_block(block).sha256());
  Block other = block;
  other.cells[2] = 5;
  BOOST_TEST(generate_block(block).sha256() != generate_block(other).sha256());
}

BOOST_AUTO_TEST_CASE(lengths_that_are_not_positive_and_finite_are_refused) {
  check_refusal(
      {{0.3, 0, 0.7}, {3, 2, 4}},
      "block 0.3 x 0 x 0.7 m in 3 x 2 x 4 cells: size: expected positive finite "
      "lengths, got 0");
  check_refusal({{-1, 1, 1}, {1, 1, 1}},
                "block -1 x 1 x 1 m in 1 x 1 x 1 cells: size: expected positive finite "
                "lengths, got -1");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  check_refusal({{1, 1, infinity}, {1, 1, 1}},
                "block 1 x 1 x inf m in 1 x 1 x 1 cells: size: expected positive finite "
                "lengths, got inf");
  check_refusal({{1, nan, 1}, {1, 1, 1}},
                "block 1 x nan x 1 m in 1 x 1 x 1 cells: size: expected positive finite "
                "lengths, got nan");
}

BOOST_AUTO_TEST_CASE(block_without_cells_along_an_axis_is_refused) {
  check_refusal({{1, 1, 1}, {2, 0, 2}},
                "block 1 x 1 x 1 m in 2 x 0 x 2 cells: cells: expected at least 1 along "
                "each axis, got 0");
}

BOOST_AUTO_TEST_CASE(more_nodes_than_can_be_numbered_are_refused) {
  check_refusal({{1, 1, 1}, {1999, 1999, 1999}},
                "block 1 x 1 x 1 m in 1999 x 1999 x 1999 cells: nodes: expected at most "
                "2^32 - 1, got 8e+09");
}

BOOST_AUTO_TEST_CASE(distortion_that_is_no_fraction_is_refused) {
  check_refusal({.size = {1, 1, 1}, .cells = {2, 2, 2}, .distortion = -0.1},
                "block 1 x 1 x 1 m in 2 x 2 x 2 cells, distorted by -0.1, seed 1: "
                "distortion: expected a finite fraction of at least 0, got -0.1");
  check_refusal({.size = {1, 1, 1},
                 .cells = {2, 2, 2},
                 .distortion = std::numeric_limits<double>::quiet_NaN()},
                "block 1 x 1 x 1 m in 2 x 2 x 2 cells, distorted by nan, seed 1: "
                "distortion: expected a finite fraction of at least 0, got nan");
}

// The hash of the mesh that gmsh's transfinite algorithm gave: stored results name it.
BOOST_AUTO_TEST_CASE(regular_block_keeps_its_hash) {
  BOOST_TEST(generate_block(block).sha256() ==
             "175e92567fe59c2e154812cd4aaffe6ed91ff38696642bc5bc63a5c5b2fc75ca");
}

BOOST_AUTO_TEST_SUITE_END()
