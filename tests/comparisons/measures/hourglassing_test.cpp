#include "comparisons/measures/hourglassing.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "meshing/generators/generate_block.hpp"

using namespace springcheck;
namespace utf = boost::unit_test;

BOOST_AUTO_TEST_SUITE(hourglassing_test)

namespace {

constexpr double h = 0.1;  // m, the cells' edge

Mesh block(CellPattern pattern = CellPattern::hexahedron, double distortion = 0) {
  return generate_block({.size = {5 * h, 5 * h, 6 * h},
                         .cells = {5, 5, 6},
                         .pattern = pattern,
                         .distortion = distortion});
}

template <class Field>
Hourglassing measured(const Mesh& mesh, Field&& field) {
  std::vector<Vector3> u;
  for (const Vector3& x : mesh.nodes()) u.push_back(field(x));
  return measure_hourglassing(mesh, u).value();
}

double sign(double x, double y) {
  return (std::lround(x / h) + std::lround(y / h)) % 2 == 0 ? 1 : -1;
}

}  // namespace

// Pressed by a tenth, E = (.81 - 1)/2 along z. Round-off.
BOOST_AUTO_TEST_CASE(a_pure_hourglass_has_its_height, *utf::tolerance(1e-9)) {
  const double a = 0.001, strain = (1 - 0.9 * 0.9) / 2;
  const Hourglassing seen = measured(block(), [&](const Vector3& x) {
    return Vector3(0, 0, -0.1 * x.z() + a * sign(x.x(), x.y()));
  });
  BOOST_TEST(seen.alternation.value() == 1);
  BOOST_TEST(seen.amplitude == a / (h * strain));
  BOOST_TEST(is_hourglassing(seen));
}

// The affine part is exact on any hexahedra, at any rotation.
BOOST_AUTO_TEST_CASE(homogeneous_deformations_do_not_hourglass) {
  Eigen::Matrix3d F = Eigen::AngleAxisd(1.2, Vector3(1, 2, 3).normalized()).matrix();
  F.col(0) *= 1.3;
  const Hourglassing seen =
      measured(block(CellPattern::hexahedron, 0.2),
               [&](const Vector3& x) { return Vector3(F * x - x); });
  BOOST_TEST(seen.amplitude < 1e-12);
  BOOST_TEST(!seen.alternation);
  BOOST_TEST(
      measured(block(), [](const Vector3&) { return Vector3(0, 0, 0); }).amplitude == 0);
}

// Bending, u = (-z^2/2, 0, x z) c, makes an hourglass in every cell that cancels between
// them, and so does torsion.
BOOST_AUTO_TEST_CASE(bent_and_twisted_cells_do_not_hourglass) {
  const Hourglassing bent = measured(block(), [](const Vector3& x) {
    return Vector3(-x.z() * x.z() / 2, 0, (x.x() - 2.5 * h) * x.z());
  });
  BOOST_TEST(bent.alternation.value() < 1e-12);
  const Hourglassing twisted = measured(block(), [](const Vector3& x) {
    return Vector3(-x.z() * x.y(), x.z() * x.x(), 0);
  });
  BOOST_TEST(twisted.alternation.value() < 1e-12);
}

BOOST_AUTO_TEST_CASE(only_hexahedra_with_a_node_inside_tell) {
  const Mesh tetrahedra = block(CellPattern::tetrahedron);
  const std::vector<Vector3> u(tetrahedra.nodes().size(), Vector3::Zero());
  BOOST_TEST(!measure_hourglassing(tetrahedra, u).has_value());
  const Mesh flat = generate_block({.size = {h, h, 2 * h}, .cells = {1, 1, 2}});
  BOOST_TEST(!measure_hourglassing(
                  flat, std::vector<Vector3>(flat.nodes().size(), Vector3::Zero()))
                  .has_value());
}

BOOST_AUTO_TEST_SUITE_END()
