#include "meshing/quality.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>

#include "meshing/generators/generate_block.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(quality_test)

namespace {

CornerPositions matrix(const std::vector<Vector3>& corners) {
  CornerPositions x(3, corners.size());
  for (Eigen::Index i = 0; const Vector3& corner : corners) x.col(i++) = corner;
  return x;
}

CornerPositions pyramid(double height) {
  return matrix({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, height}});
}

/// Cells whose edges are all 1.
CornerPositions regular(CellType type) {
  const double h = std::sqrt(3.) / 2;
  switch (type) {
    case CellType::tetrahedron:
      return matrix({{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0.5, h / 3, std::sqrt(2. / 3)}});
    case CellType::pyramid:
      return pyramid(std::sqrt(0.5));
    case CellType::prism:
      return matrix(
          {{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0, 0, 1}, {1, 0, 1}, {0.5, h, 1}});
    default:
      return matrix({{0, 0, 0},
                     {1, 0, 0},
                     {1, 1, 0},
                     {0, 1, 0},
                     {0, 0, 1},
                     {1, 0, 1},
                     {1, 1, 1},
                     {0, 1, 1}});
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(regular_cells_have_1, *boost::unit_test::tolerance(1e-14)) {
  for (const CellType type : all_cell_types) {
    BOOST_TEST(scaled_jacobian(regular(type)) == 1);
    BOOST_TEST(edge_ratio(regular(type)) == 1);
  }
}

BOOST_AUTO_TEST_CASE(size_and_place_do_not_matter, *boost::unit_test::tolerance(1e-12)) {
  for (const CellType type : all_cell_types) {
    CornerPositions x = 1e-3 * regular(type);
    x.colwise() += Vector3(0.3, -0.2, 0.1);
    BOOST_TEST(scaled_jacobian(x) == 1);
  }
}

// Pull any corner of a regular cell off: its own or a neighbour's angle gets worse.
BOOST_AUTO_TEST_CASE(every_corner_counts) {
  for (const CellType type : all_cell_types)
    for (Eigen::Index i = 0; i < regular(type).cols(); ++i)
      for (const double step : {-0.2, 0.2}) {
        CornerPositions x = regular(type);
        const Vector3 outward = x.col(i) - x.rowwise().mean();
        x.col(i) += step * outward;
        BOOST_TEST(scaled_jacobian(x) < 0.99);
      }
}

// One corner of a cube and its three neighbours, by hand: at the far ends of the edges
// the determinant is 1, the lengths 1, sqrt 2 and sqrt 2.
BOOST_AUTO_TEST_CASE(corner_of_a_cube_has_the_tetrahedron_known_by_hand,
                     *boost::unit_test::tolerance(1e-14)) {
  const CornerPositions x = matrix({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  BOOST_TEST(scaled_jacobian(x) == std::sqrt(2.) / 2);
  BOOST_TEST(edge_ratio(x) == std::sqrt(2.));
}

// By hand, with s = sqrt(h^2 + 1/2), it is h/s at the base and h/s^3 at the apex, times
// sqrt 2.
BOOST_AUTO_TEST_CASE(flat_pyramid_is_judged_at_its_base_and_tall_one_at_its_apex,
                     *boost::unit_test::tolerance(1e-14)) {
  const double flat = std::sqrt(0.01 + 0.5), tall = std::sqrt(4 + 0.5);
  BOOST_TEST(scaled_jacobian(pyramid(0.1)) == std::sqrt(2.) * 0.1 / flat);
  BOOST_TEST(scaled_jacobian(pyramid(2)) == std::sqrt(2.) * 2 / std::pow(tall, 3));
}

// The pyramid's apex leans over one corner of the base, whatever the number of that
// corner.
BOOST_AUTO_TEST_CASE(pyramid_may_start_at_any_corner_of_its_base,
                     *boost::unit_test::tolerance(1e-14)) {
  CornerPositions x = pyramid(2);
  x.col(4) += Vector3(-0.6, -0.8, 0);
  for (int turn = 1; turn < 4; ++turn) {
    CornerPositions turned = x;
    for (int i = 0; i < 4; ++i) turned.col((i + turn) % 4) = x.col(i);
    BOOST_TEST(scaled_jacobian(turned) == scaled_jacobian(x));
  }
}

BOOST_AUTO_TEST_CASE(folded_cell_has_less_than_0) {
  CornerPositions x = regular(CellType::hexahedron);
  x.col(0) = Vector3::Constant(0.6);
  BOOST_TEST(scaled_jacobian(x) < 0);
}

// Boxes of two sizes: everything is known by hand.
BOOST_AUTO_TEST_CASE(mesh_of_two_boxes_has_their_figures,
                     *boost::unit_test::tolerance(1e-14)) {
  std::vector<Vector3> nodes;
  for (const double z : {0., 1., 4.})
    for (const auto& [x, y] : {std::pair{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}})
      nodes.emplace_back(x, y, z);
  const Quality quality = quality_of(
      Mesh("boxes", nodes, {{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}}, {}));
  const CellQuality& all = quality.all;
  BOOST_TEST(all.cells == 2U);
  BOOST_TEST(all.volume == 4);
  BOOST_TEST(all.smallest_volume == 1);
  BOOST_TEST(all.mean_volume == 2);
  BOOST_TEST(all.largest_volume == 3);
  BOOST_TEST(all.smallest_scaled_jacobian == 1);
  BOOST_TEST(all.mean_scaled_jacobian == 1);
  BOOST_TEST(all.largest_edge_ratio == 3);
  BOOST_TEST(all.mean_edge_ratio == 2);
  BOOST_TEST(all.histogram == (std::array<std::size_t, 10>{0, 0, 0, 0, 0, 0, 0, 0, 0, 2}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(types_add_up_to_all, *boost::unit_test::tolerance(1e-13)) {
  const Mesh mesh = generate_block({.size = {1, 1, 1},
                                    .cells = {4, 4, 4},
                                    .pattern = CellPattern::mixed,
                                    .distortion = 0.2});
  const Quality quality = quality_of(mesh);
  BOOST_TEST(quality.by_type.size() == 4U);
  std::size_t cells = 0;
  double volume = 0, jacobians = 0, smallest = 1;
  std::array<std::size_t, 10> histogram{};
  for (const auto& [type, of_type] : quality.by_type) {
    BOOST_TEST(of_type.cells == mesh.count(type));
    BOOST_TEST(std::accumulate(of_type.histogram.begin(), of_type.histogram.end(),
                               std::size_t{0}) == of_type.cells);
    cells += of_type.cells;
    volume += of_type.volume;
    jacobians += of_type.mean_scaled_jacobian * static_cast<double>(of_type.cells);
    smallest = std::min(smallest, of_type.smallest_scaled_jacobian);
    for (std::size_t bin = 0; bin < 10; ++bin) histogram[bin] += of_type.histogram[bin];
  }
  BOOST_TEST(quality.all.cells == cells);
  BOOST_TEST(quality.all.volume == volume);
  BOOST_TEST(quality.all.volume == 1);
  BOOST_TEST(quality.all.mean_scaled_jacobian == jacobians / static_cast<double>(cells));
  BOOST_TEST(quality.all.smallest_scaled_jacobian == smallest);
  BOOST_TEST(quality.all.histogram == histogram, boost::test_tools::per_element());
}

// By hand, the worst corners of a cube's six tetrahedra have edges 1, sqrt 2, sqrt 3 and
// determinant 1; all twelve edges of the pyramids' bases are 1, the others sqrt(3/4).
BOOST_AUTO_TEST_CASE(blocks_of_cubes_have_the_qualities_known_by_hand,
                     *boost::unit_test::tolerance(1e-12)) {
  const auto quality = [](CellPattern pattern) {
    return quality_of(generate_block(
                          {.size = {3, 3, 3}, .cells = {3, 3, 3}, .pattern = pattern}))
        .all;
  };
  const CellQuality tetrahedra = quality(CellPattern::tetrahedron);
  BOOST_TEST(tetrahedra.smallest_scaled_jacobian == 1 / std::sqrt(3.));
  BOOST_TEST(tetrahedra.mean_edge_ratio == std::sqrt(3.));
  const CellQuality pyramids = quality(CellPattern::pyramid);
  BOOST_TEST(pyramids.smallest_scaled_jacobian == std::sqrt(2. / 3));
  BOOST_TEST(pyramids.mean_edge_ratio == std::sqrt(4. / 3));
  BOOST_TEST(quality(CellPattern::prism).smallest_scaled_jacobian == std::sqrt(2. / 3));
  BOOST_TEST(quality(CellPattern::mixed).smallest_scaled_jacobian == 1 / std::sqrt(3.));
}

BOOST_AUTO_TEST_SUITE_END()
