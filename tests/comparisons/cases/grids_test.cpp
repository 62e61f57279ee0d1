#include <boost/test/unit_test.hpp>
#include <numeric>
#include <tuple>

#include "comparisons/cases/grids.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/generators/generate_block.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(grids_test)

namespace {

const std::array<double, 3> size{0.05, 0.03, 0.02};
const Cells coarse{3, 2, 1}, fine{6, 4, 3};

}  // namespace

// The fine grid's own coordinates, read off at the coarse nodes, are theirs.
BOOST_AUTO_TEST_CASE(coarse_nodes_are_found_among_the_fine_ones) {
  const Mesh on_fine = generate_block({size, fine});
  const Mesh on_coarse = generate_block({size, coarse});
  const auto found = interpolated(on_fine.nodes(), {size, fine}, on_coarse.nodes());
  BOOST_TEST_REQUIRE(found.size() == on_coarse.nodes().size());
  for (std::size_t n = 0; n < found.size(); ++n)
    BOOST_TEST((found[n] - on_coarse.nodes()[n]).norm() < 1e-15);
}

// A field that is itself trilinear in each cell is met everywhere, to rounding: x y z and
// lower powers are so in all cells at once.
BOOST_AUTO_TEST_CASE(trilinear_fields_are_interpolated_exactly) {
  const auto field_at = [](const Vector3& x) {
    const auto [a, b, c] = std::tuple(x.x() / 0.05, x.y() / 0.03, x.z() / 0.02);
    return Vector3(a * b * c, 1 + a * b - c, b * c);
  };
  const Mesh grid = generate_block({size, fine});
  std::vector<Vector3> on_fine;
  for (const Vector3& x : grid.nodes()) on_fine.push_back(field_at(x));
  const Mesh mixed = generate_block({size, {5, 5, 5}, CellPattern::mixed, 0.2});
  const auto found = interpolated(on_fine, {size, fine}, mixed.nodes());
  for (std::size_t n = 0; n < found.size(); ++n)
    BOOST_TEST((found[n] - field_at(mixed.nodes()[n])).norm() < 1e-13);
}

// Along axes with an even number of cells (x and y here) squares are interpolated exactly
// too, between the nodes as well; along the others they are not.
BOOST_AUTO_TEST_CASE(quadratic_fields_are_interpolated_exactly_on_pairs_of_cells) {
  const auto field_at = [](const Vector3& x) {
    const auto [a, b, c] = std::tuple(x.x() / 0.05, x.y() / 0.03, x.z() / 0.02);
    return Vector3(a * a * b * b * c, 1 - a * a + b * b, c * c);
  };
  const Mesh grid = generate_block({size, fine});
  std::vector<Vector3> on_fine;
  for (const Vector3& x : grid.nodes()) on_fine.push_back(field_at(x));
  const Mesh mixed = generate_block({size, {5, 5, 5}, CellPattern::mixed, 0.2});
  const auto found = interpolated(on_fine, {size, fine}, mixed.nodes());
  double off_along_z = 0;
  for (std::size_t n = 0; n < found.size(); ++n) {
    const Vector3 error = found[n] - field_at(mixed.nodes()[n]);
    BOOST_TEST(error.head<2>().norm() < 1e-13);
    off_along_z = std::max(off_along_z, std::abs(error.z()));
  }
  BOOST_TEST(off_along_z > 0.01);
}

BOOST_AUTO_TEST_CASE(nodes_are_told_from_other_points) {
  const Mesh on_coarse = generate_block({size, coarse});
  BOOST_TEST(are_nodes_of({size, fine}, generate_block({size, {3, 2, 3}}).nodes()));
  BOOST_TEST(are_nodes_of({size, fine}, on_coarse.nodes()));
  BOOST_TEST(!are_nodes_of({size, coarse}, generate_block({size, fine}).nodes()));
  BOOST_TEST(!are_nodes_of(
      {size, {5, 5, 5}},
      generate_block({size, {5, 5, 5}, CellPattern::hexahedron, 0.2}).nodes()));
}

// A squeezed block, so that cells differ: the fine cells' volumes add up to the coarse
// cells' where faces stay plane.
BOOST_AUTO_TEST_CASE(fine_cells_are_summed_into_the_coarse_cell_around_them) {
  const auto volumes = [](const Cells& cells) {
    const Mesh block = generate_block({size, cells});
    std::vector<double> values;
    for (const CellNodes& cell : block.cells()) {
      const Vector3 a = block.nodes()[cell[0]], b = block.nodes()[cell[6]];
      const auto cubed = [](double x) { return x * x * x; };
      values.push_back((cubed(b.x()) - cubed(a.x())) * (cubed(b.y()) - cubed(a.y())) *
                       (cubed(b.z()) - cubed(a.z())));
    }
    return values;
  };
  const auto sums = summed_over_coarse_cells(volumes(fine), fine, coarse);
  const auto expected = volumes(coarse);
  BOOST_TEST_REQUIRE(sums.size() == expected.size());
  for (std::size_t c = 0; c < sums.size(); ++c)
    BOOST_TEST(sums[c] == expected[c], boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(whole_multiples_are_refinements) {
  BOOST_TEST(is_refinement(fine, coarse));
  BOOST_TEST(is_refinement(coarse, coarse));
  BOOST_TEST(!is_refinement({6, 3, 3}, coarse));
  BOOST_TEST((refined(coarse, 4) == Cells{12, 8, 4}));
  BOOST_TEST((coarsened({10, 5, 1}) == Cells{5, 3, 1}));
  BOOST_CHECK_THROW(refined({1 << 30, 1, 1}, 4), InputError);
}

BOOST_AUTO_TEST_CASE(the_size_of_a_cell_is_the_cube_root_of_its_volume) {
  BOOST_TEST(cell_size({{0.4, 0.4, 0.8}, {4, 4, 8}}) == 0.1,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
