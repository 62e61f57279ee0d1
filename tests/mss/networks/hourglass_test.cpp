#include "mss/networks/hourglass.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mss/networks/cell_springs.hpp"
#include "tests/mss/any_cells.hpp"
#include "tests/mss/assembled.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(hourglass_test)

namespace {

constexpr Material soft{.young_modulus = 6, .poisson_ratio = 0.25, .density = 1};

std::vector<CellSpring> springs_of(const CornerPositions& x) {
  return hourglass_springs(x, cell_volume(x), soft);
}

/// Right prism on a triangle with two sides of a, of height h.
CornerPositions prism(double a, double h) {
  CornerPositions x(3, 6);
  const double half = a / 2, upright = std::sqrt(3.) / 2 * a;
  x << 0, a, half, 0, a, half,       //
      0, 0, upright, 0, 0, upright,  //
      0, 0, 0, h, h, h;
  return x;
}

}  // namespace

// By hand: m = .843/2.5 = .3372, eta = .06382 on edges and .1124 on face diagonals, whose
// square length is 2. V = 1, E = 6. The tolerance is that of the digits given.
BOOST_AUTO_TEST_CASE(cube_has_the_constants_computed_by_hand) {
  const Mesh mesh = cube(1, 1);
  const auto springs = springs_of(corners(mesh.cells()[0], mesh.nodes()));
  BOOST_TEST(springs.size() == 24U);
  for (const CellSpring& spring : springs) {
    const bool is_edge = spring.rest.squaredNorm() < 1.5;
    BOOST_TEST(spring.stiffness == (is_edge ? 0.3829393 : 0.3372),
               boost::test_tools::tolerance(1e-6));
  }
}

BOOST_AUTO_TEST_CASE(pyramid_has_its_edges_and_the_base_s_diagonals) {
  CornerPositions x(3, 5);
  x << 0, 1, 1, 0, 0.5, 0, 0, 1, 1, 0.5, 0, 0, 0, 0, 3;
  const auto springs = springs_of(x);
  BOOST_TEST(springs.size() == 10U);
  for (const CellSpring& spring : springs) {  // k l^2 as above, V = 1
    const bool is_diagonal = spring.rest.z() == 0 && spring.rest.squaredNorm() > 1.5;
    BOOST_TEST(spring.stiffness * spring.rest.squaredNorm() ==
                   (is_diagonal ? 2 * 0.3372 : 0.3829393),
               boost::test_tools::tolerance(1e-6));
  }
}

// By hand with a = 1, h = 1.5, E = 6 and mu = 2.4, in parts of V: the triangle's edges
// have 1, diagonals of square length 3.25 have .24 * 3.25/2.25, and upright edges 6/27 -
// .12.
BOOST_AUTO_TEST_CASE(prism_has_the_constants_computed_by_hand,
                     *boost::unit_test::tolerance(1e-13)) {
  const CornerPositions x = prism(1, 1.5);
  const double V = cell_volume(x);
  const auto springs = springs_of(x);
  BOOST_TEST(springs.size() == 15U);
  for (const CellSpring& spring : springs) {
    const double square = spring.rest.squaredNorm();
    const double expected = square < 1.1   ? 1
                            : square < 2.3 ? 6. / 27 - 0.12
                                           : 0.24 * 3.25 / 2.25;
    BOOST_TEST(spring.stiffness == V * expected);
  }
}

BOOST_AUTO_TEST_CASE(tetrahedron_has_none) {
  CornerPositions x(3, 4);
  x << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  BOOST_TEST(springs_of(x).empty());
}

// Beyond h/a = 1.8, for which its constants were tried, a prism's upright springs vanish
// at h^2 = 25/6 a^2 (nu = 1/4); it does not lose its shape. The eigenvalues are relative
// to E V, and far above round-off.
BOOST_AUTO_TEST_CASE(prism_of_any_height_has_six_zero_modes_alone) {
  for (const double h : {0.1, 0.5, 1., 1.8, 3., 5.})
    for (const double nu : {-0.5, 0., 0.25, 0.45, 0.499})
      BOOST_TEST_CONTEXT("h/a " << h << ", nu " << nu) {
        const CornerPositions x = prism(1, h);
        std::vector<Vector3> nodes;
        for (Eigen::Index i = 0; i < 6; ++i) nodes.emplace_back(x.col(i));
        const Mesh mesh("prism", nodes, {{0, 1, 2, 3, 4, 5}}, {});
        const Network network =
            build_network(mesh, {.young_modulus = 1, .poisson_ratio = nu, .density = 1},
                          in_shear_modulus_form(SpringModel::affine));
        const Eigen::MatrixXd lower =
            lower_triangle(network, tangent_at(network, network.rest_positions),
                           std::vector<bool>(18, true));
        const Eigen::VectorXd spectrum =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(lower).eigenvalues();
        BOOST_TEST(spectrum.head<6>().cwiseAbs().maxCoeff() < 1e-13 * spectrum[17]);
        BOOST_TEST(spectrum[6] > 1e-3);
      }
}

BOOST_AUTO_TEST_SUITE_END()
