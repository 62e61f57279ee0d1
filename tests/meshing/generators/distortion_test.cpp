#include <boost/test/unit_test.hpp>

#include "meshing/basics/input_error.hpp"
#include "meshing/cell_geometry.hpp"
#include "meshing/generators/generate_block.hpp"
#include "meshing/generators/uniform_number.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(distortion_test)

namespace {

Block block(CellPattern pattern, double distortion) {
  return {.size = {0.3, 0.2, 0.7},
          .cells = {5, 3, 4},
          .pattern = pattern,
          .distortion = distortion};
}

bool is_inside(const Vector3& x) {
  return x.x() > 0 && x.x() < 0.3 && x.y() > 0 && x.y() < 0.2 && x.z() > 0 && x.z() < 0.7;
}

constexpr std::array grid_patterns{CellPattern::hexahedron,    CellPattern::tetrahedron,
                                   CellPattern::prism,         CellPattern::pyramid,
                                   CellPattern::mixed,         CellPattern::tetrahedron_5,
                                   CellPattern::tetrahedron_12};

}  // namespace

// The standard fixes the 10000th number of the engine's default seed.
BOOST_AUTO_TEST_CASE(uniform_numbers_are_the_engines_upper_53_bits) {
  std::mt19937_64 random;
  random.discard(9999);
  BOOST_TEST(uniform_number(random) ==
             static_cast<double>(9981545732273789042U >> 11U) * 0x1p-53);
}

BOOST_AUTO_TEST_CASE(nodes_inside_move_within_reach_and_those_on_the_surface_stay) {
  const auto grid_nodes = std::size_t{6 * 4 * 5};
  const Vector3 edge(0.3 / 5, 0.2 / 3, 0.7 / 4);
  for (const CellPattern pattern : grid_patterns) {
    const Mesh regular = generate_block(block(pattern, 0));
    const Mesh mesh = generate_block(block(pattern, 0.15));
    Vector3 lowest = Vector3::Zero(), highest = Vector3::Zero();
    for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
      const Vector3 shift = mesh.nodes()[n] - regular.nodes()[n];
      lowest = lowest.cwiseMin(shift.cwiseQuotient(edge));
      highest = highest.cwiseMax(shift.cwiseQuotient(edge));
      if (n < grid_nodes)  // a centre may move by round-off beside the surface alone
        BOOST_TEST((shift != Vector3::Zero()) == is_inside(regular.nodes()[n]));
    }
    // Two dozen nodes or more: some come close to the limits, none beyond them.
    BOOST_TEST((highest.array() <= 0.15).all());
    BOOST_TEST((highest.array() > 0.1).all());
    BOOST_TEST((lowest.array() >= -0.15).all());
    BOOST_TEST((lowest.array() < -0.1).all());
  }
}

// Bilinear faces are shared: what one cell loses its neighbour gains, to round-off.
BOOST_AUTO_TEST_CASE(volume_stays, *boost::unit_test::tolerance(1e-13)) {
  for (const CellPattern pattern : grid_patterns)
    BOOST_TEST(generate_block(block(pattern, 0.15)).volume() == 0.3 * 0.2 * 0.7);
}

BOOST_AUTO_TEST_CASE(centre_nodes_move_to_the_mean_of_their_hexahedrons_corners) {
  const Mesh grid = generate_block(block(CellPattern::hexahedron, 0.15));
  const Mesh pyramids = generate_block(block(CellPattern::pyramid, 0.15));
  for (std::size_t c = 0; c < grid.cells().size(); ++c) {
    const Vector3 mean = corners(grid.cells()[c], grid.nodes()).rowwise().mean();
    // Eight terms in another order: round-off.
    BOOST_TEST((pyramids.nodes()[grid.nodes().size() + c] - mean).norm() < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(grid_nodes_move_alike_in_all_patterns) {
  const Mesh grid = generate_block(block(CellPattern::hexahedron, 0.15));
  for (const CellPattern pattern : grid_patterns)
    BOOST_TEST(std::equal(grid.nodes().begin(), grid.nodes().end(),
                          generate_block(block(pattern, 0.15)).nodes().begin()));
}

BOOST_AUTO_TEST_CASE(other_seeds_move_nodes_elsewhere) {
  Block other = block(CellPattern::hexahedron, 0.15);
  const std::string hash = generate_block(other).sha256();
  BOOST_TEST(generate_block(other).sha256() == hash);
  other.seed = 2;
  BOOST_TEST(generate_block(other).sha256() != hash);
}

BOOST_AUTO_TEST_CASE(distortion_that_turns_a_cell_over_is_refused) {
  BOOST_CHECK_EXCEPTION(
      generate_block(block(CellPattern::hexahedron, 1)), InputError,
      [](const InputError& error) {
        const std::string message = error.what();
        BOOST_TEST(message.starts_with("block 0.3 x 0.2 x 0.7 m in 5 x 3 x 4 cells, "
                                       "distorted by 1, seed 1: hexahedron "),
                   message);
        BOOST_TEST(message.find("expected positive Jacobians at its corners") !=
                       std::string::npos,
                   message);
        return true;
      });
}

BOOST_AUTO_TEST_SUITE_END()
