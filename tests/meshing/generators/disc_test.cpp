#include "meshing/generators/disc.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "meshing/basics/input_error.hpp"
#include "meshing/cell_geometry.hpp"
#include "meshing/conformity.hpp"
#include "meshing/quality.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(disc_test)

namespace {

Disc disc(int across, int layers) {
  return {.diameter = 0.015, .height = 0.003, .across = across, .layers = layers};
}

/// int (x^2 + y^2) dA of the polygon that the rim is: triangles from the axis.
double polar_moment(const Mesh& mesh) {
  double sum = 0;
  for (const FaceNodes& face : mesh.region("surface").faces) {
    std::vector<Vector3> below;
    for (const NodeIndex node : face)
      if (mesh.nodes()[node].z() == 0) below.push_back(mesh.nodes()[node]);
    if (below.size() != 2) continue;
    const Vector3 &a = below[0], &b = below[1];
    sum +=
        std::abs(a.cross(b).z()) / 2 * (a.squaredNorm() + a.dot(b) + b.squaredNorm()) / 6;
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_disc_is_of_hexahedra_that_fit_together) {
  for (const int across : {3, 4, 5, 8, 13}) {
    const Mesh mesh = generate_disc(disc(across, 2));
    BOOST_CHECK_NO_THROW(check_conformity(mesh));
    const int sector = std::max(1, across / 4), core = across - 2 * sector;
    const auto in_layer = static_cast<std::size_t>(core * core + 4 * core * sector);
    BOOST_TEST(mesh.cells().size() == 2 * in_layer);
    BOOST_TEST(mesh.count(CellType::hexahedron) == mesh.cells().size());
    BOOST_TEST(mesh.region("bottom").faces.size() == in_layer);
    BOOST_TEST(mesh.region("top").faces.size() == in_layer);
    BOOST_TEST(mesh.region("surface").faces.size() ==
               static_cast<std::size_t>(2 * 4 * core));
    // The worst corner is that of a sector, between a chord and a spoke; .57 with 13.
    BOOST_TEST(quality_of(mesh).all.smallest_scaled_jacobian > 0.5);
  }
}

// Bit for bit: plates are glued there.
BOOST_AUTO_TEST_CASE(plates_are_at_0_and_at_the_height) {
  for (const double scale : {1e-3, 1., 1e3}) {
    const double height = 0.0037 * scale;
    const Mesh mesh = generate_disc(
        {.diameter = 0.015 * scale, .height = height, .across = 8, .layers = 3});
    for (const NodeIndex node : mesh.region("bottom").nodes)
      BOOST_TEST(mesh.nodes()[node].z() == 0);
    for (const NodeIndex node : mesh.region("top").nodes)
      BOOST_TEST(mesh.nodes()[node].z() == height);
  }
}

// The polar moment of a regular polygon of N sides in the unit circle is
// N/2 sin(2 pi/N) (2 + cos(2 pi/N))/6.
BOOST_AUTO_TEST_CASE(the_rim_is_a_regular_polygon_on_the_circle) {
  for (const int across : {8, 16, 24}) {
    const Mesh mesh = generate_disc(disc(across, 1));
    const double sides = 2 * across, x = 2 * std::numbers::pi / sides;
    const double expected =
        std::pow(0.0075, 4) * sides / 2 * std::sin(x) * (2 + std::cos(x)) / 6;
    BOOST_TEST(polar_moment(mesh) == expected, boost::test_tools::tolerance(1e-9));
    const double missing = 1 - expected / (std::numbers::pi / 2 * std::pow(0.0075, 4));
    // The series of which the docstring has the first term: x^4/45 and less follows.
    BOOST_TEST(missing == x * x / 3, boost::test_tools::tolerance(0.05));
    const double area = sides / 2 * std::sin(x) * 0.0075 * 0.0075;
    BOOST_TEST(mesh.volume() == area * 0.003, boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(equal_discs_get_equal_meshes) {
  BOOST_TEST(generate_disc(disc(8, 2)).sha256() == generate_disc(disc(8, 2)).sha256());
}

BOOST_AUTO_TEST_CASE(discs_that_cannot_be_are_refused) {
  const auto check_refusal = [](const Disc& bad, const std::string& message) {
    BOOST_CHECK_EXCEPTION(generate_disc(bad), InputError, [&](const InputError& error) {
      BOOST_TEST(error.what() == message);
      return true;
    });
  };
  check_refusal(disc(2, 1),
                "disc 0.015 x 0.003 m in 2 cells across, 1 layers: cells: expected at "
                "least 3 across a disc, got 2");
  check_refusal(disc(4, 0),
                "disc 0.015 x 0.003 m in 4 cells across, 0 layers: cells: expected at "
                "least 1 along each axis, got 0");
  check_refusal({.diameter = 0.015, .height = 0, .across = 4, .layers = 1},
                "disc 0.015 x 0 m in 4 cells across, 1 layers: size: expected positive "
                "finite lengths, got 0");
}

BOOST_AUTO_TEST_SUITE_END()
