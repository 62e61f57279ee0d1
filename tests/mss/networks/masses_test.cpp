#include "mss/networks/masses.hpp"
#include "meshing/generators/generate_block.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>

#include "tests/mss/any_cells.hpp"
#include "tests/referee/figures.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(masses_test)

namespace {

CornerPositions pyramid_of_height(double h) {
  CornerPositions x(3, 5);
  x << 0, 1, 1, 0, 0.5,  //
      0, 0, 1, 1, 0.5,   //
      0, 0, 0, 0, h;
  return x;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.);
}

Vector3 centre(const CornerPositions& x, const std::vector<double>& shares) {
  Vector3 moment = Vector3::Zero();
  for (std::size_t a = 0; a < shares.size(); ++a)
    moment += shares[a] * x.col(static_cast<Eigen::Index>(a));
  return moment / sum(shares);
}

}  // namespace

// By hand: c_z = h/4, xm_z = h/5, S_zz = 4/25 h^2, so that the apex gets 5/4 and a corner
// of the base 15/16 of V/5.
BOOST_AUTO_TEST_CASE(apex_of_a_pyramid_gets_five_quarters_of_a_fifth,
                     *boost::unit_test::tolerance(1e-14)) {
  const std::vector<double> shares = nodal_volumes(pyramid_of_height(3));
  BOOST_TEST(shares[4] == 5. / 4 / 5);
  for (std::size_t a = 0; a < 4; ++a) BOOST_TEST(shares[a] == 15. / 16 / 5);
}

// Golec 2018, Eq. 6.1: a pyramid's centre of mass is h/20 below its centroid at h/4.
BOOST_AUTO_TEST_CASE(equal_masses_of_a_pyramid_are_a_twentieth_of_its_height_too_low,
                     *boost::unit_test::tolerance(1e-14)) {
  const CornerPositions x = pyramid_of_height(3);
  const std::vector<double> equal(5, equal_nodal_volume(x));
  BOOST_TEST(sum(equal) == 1);
  BOOST_TEST(cell_centroid(x).z() - centre(x, equal).z() == 3. / 20);
}

// The shares are exact on paper for every cell, so that the tolerance is round-off. None
// of these cells falls back on equal shares.
BOOST_AUTO_TEST_CASE(shares_keep_volume_and_centroid_of_distorted_cells) {
  for (const auto& [name, mesh] : distorted_cubes(3, 1))
    for (const CellNodes& cell : mesh.cells()) {
      const CornerPositions x = corners(cell, mesh.nodes());
      const std::vector<double> shares = nodal_volumes(x);
      BOOST_TEST(std::abs(sum(shares) - cell_volume(x)) < 1e-14, name);
      BOOST_TEST((centre(x, shares) - cell_centroid(x)).norm() < 1e-13, name);
      BOOST_TEST(*std::ranges::min_element(shares) > 0);
    }
}

// The body's weight pulls where it should: mass and first moment of the box. Of bodies
// whose inner nodes alone are moved; round-off of 400 cells.
BOOST_AUTO_TEST_CASE(network_has_the_mass_and_centre_of_mass_of_the_body) {
  for (const auto& [name, mesh] : distorted_cubes(3, 1)) {
    const Network network =
        build_network(mesh, {.young_modulus = 1, .poisson_ratio = 0.3, .density = 7},
                      in_shear_modulus_form(SpringModel::affine));
    Vector3 moment = Vector3::Zero();
    for (std::size_t n = 0; n < mesh.nodes().size(); ++n)
      moment += network.masses[n] * mesh.nodes()[n];
    BOOST_TEST(sum(network.masses) == 7 * 27, boost::test_tools::tolerance(1e-13));
    BOOST_TEST((moment / sum(network.masses) - Vector3::Constant(1.5)).norm() < 1e-13,
               name);
  }
}

// A prism twisted by half a turn on its way up, by luck of its proportions with positive
// Jacobians all the same: a linear share would leave a node -1/6 of its sixth.
BOOST_AUTO_TEST_CASE(cell_that_would_get_a_negative_share_gets_equal_ones) {
  CornerPositions x(3, 6);
  x << 0, 4, 0, 4, 0, 1,  //
      0, 0, 4, 4, 2, 2,   //
      0, 0, 0, 4, 4, 4;
  const double volume = cell_volume(x);
  BOOST_TEST_REQUIRE(smallest_corner_jacobian(x) > 0);
  const Vector3 mean = x.rowwise().mean();
  const CornerPositions from_mean = x.colwise() - mean;
  const Matrix3 S = from_mean * from_mean.transpose() / 6;
  const Eigen::VectorXd linear =
      1 + (from_mean.transpose() * S.inverse() * (cell_centroid(x) - mean)).array();
  BOOST_TEST(linear.minCoeff() == -1. / 6, boost::test_tools::tolerance(1e-13));
  for (const double share : nodal_volumes(x))
    BOOST_TEST(share == volume / 6, boost::test_tools::tolerance(1e-14));
}

namespace {
using LocalTetrahedron = std::array<Eigen::Index, 4>;
constexpr std::array<LocalTetrahedron, 1> whole{{{0, 1, 2, 3}}};
constexpr std::array<LocalTetrahedron, 2> in_pyramid{{{0, 1, 3, 4}, {1, 2, 3, 4}}};
constexpr std::array<LocalTetrahedron, 3> in_prism{
    {{0, 1, 2, 3}, {1, 3, 4, 5}, {1, 2, 3, 5}}};
constexpr std::array<LocalTetrahedron, 6> in_hexahedron{
    {{0, 1, 2, 4}, {1, 4, 5, 6}, {1, 2, 4, 6}, {0, 2, 3, 4}, {2, 4, 6, 7}, {2, 3, 4, 7}}};

std::span<const LocalTetrahedron> tetrahedra(CellType type) {
  switch (type) {
    case CellType::tetrahedron:
      return whole;
    case CellType::pyramid:
      return in_pyramid;
    case CellType::prism:
      return in_prism;
    case CellType::hexahedron:
      return in_hexahedron;
  }
  return {};
}

/// Volume as the sum of the tetrahedra that the cell is cut into [m^3]: a prism into 3, a
/// pyramid into 2, a hexahedron into two prisms. Exact where the faces are plane; of a
/// warped face it sees one diagonal, the neighbour perhaps the other, and the volumes of
/// cells that fill a body do not add up to the body's.
/// Source: Golec 2018, Eq. 6.3 to 6.6 and section 6.1, whose P1 to P6 of a prism are our
/// 0, 1, 2, 4, 3, 5.
double volume_of_tetrahedra(const CornerPositions& x) {
  double six_volumes = 0;
  for (const auto& [a, b, c, d] :
       tetrahedra(type_with(static_cast<std::size_t>(x.cols())))) {
    const Vector3 o = x.col(a), to_b = x.col(b) - o, to_c = x.col(c) - o,
                  to_d = x.col(d) - o;
    six_volumes += to_b.cross(to_c).dot(to_d);
  }
  return six_volumes / 6;
}

}  // namespace

// Plane faces: exact, whichever way they are cut. Sheared, to tell all nodes apart.
BOOST_AUTO_TEST_CASE(volume_of_tetrahedra_is_exact_for_plane_faces,
                     *boost::unit_test::tolerance(1e-13)) {
  const Matrix3 F = (Matrix3() << 2, 0.5, -0.3, 0.1, 1.5, 0.4, -0.2, 0.7, 0.9).finished();
  for (const CellPattern pattern : {CellPattern::tetrahedron, CellPattern::pyramid,
                                    CellPattern::prism, CellPattern::hexahedron}) {
    const Mesh mesh =
        generate_block({.size = {1, 1, 1}, .cells = {2, 2, 2}, .pattern = pattern});
    for (const CellNodes& cell : mesh.cells()) {
      const CornerPositions x = F * corners(cell, mesh.nodes());
      BOOST_TEST(volume_of_tetrahedra(x) == cell_volume(x));
    }
  }
}

// Eq. 6.6 on cubes whose corners are off by up to 20 % of their edge: the referee's other
// 200,000, to about four standard deviations of 20,000, whose spread is about half the
// figure.
BOOST_AUTO_TEST_CASE(six_tetrahedra_miss_a_warped_hexahedron_s_volume) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> move(-0.2, 0.2);
  const Mesh mesh = cube(1, 1);
  constexpr int count = 20000;
  double squares = 0, absolutes = 0;
  for (int i = 0; i < count; ++i) {
    CornerPositions x = corners(mesh.cells().front(), mesh.nodes());
    for (double& coordinate : x.reshaped()) coordinate += move(random);
    const double error = volume_of_tetrahedra(x) / cell_volume(x) - 1;
    squares += error * error / count;
    absolutes += std::abs(error) / count;
  }
  const auto figure = [](const char* quantity) {
    return referee::figure("volumes", "six tetrahedra", quantity);
  };
  BOOST_TEST(std::abs(std::sqrt(squares) - figure("root mean square")) < 0.001);
  BOOST_TEST(std::abs(absolutes - figure("mean of the absolute value")) < 0.001);
}

// The hexahedra fill a box whose surface is plane, and their exact volumes add up to it.
// The tetrahedra of two neighbours cut their common face by different diagonals.
BOOST_AUTO_TEST_CASE(volumes_of_tetrahedra_do_not_add_up_to_the_body) {
  const Mesh mesh =
      generate_block({.size = {4, 4, 4}, .cells = {4, 4, 4}, .distortion = 0.2});
  double of_tetrahedra = 0;
  for (const CellNodes& cell : mesh.cells())
    of_tetrahedra += volume_of_tetrahedra(corners(cell, mesh.nodes()));
  BOOST_TEST(mesh.volume() == 64, boost::test_tools::tolerance(1e-13));
  BOOST_TEST(std::abs(of_tetrahedra / 64 - 1) > 1e-4);
}

BOOST_AUTO_TEST_SUITE_END()
