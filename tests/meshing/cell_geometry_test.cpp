#include "meshing/cell_geometry.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(cell_geometry_test)

namespace {

using HexahedronCorners = std::array<Vector3, 8>;

CornerPositions matrix(const HexahedronCorners& x) {
  CornerPositions columns(3, 8);
  for (Eigen::Index i = 0; const Vector3& corner : x) columns.col(i++) = corner;
  return columns;
}

double cell_volume(const HexahedronCorners& x) {
  return springcheck::cell_volume(matrix(x));
}

double smallest_corner_jacobian(const HexahedronCorners& x) {
  return springcheck::smallest_corner_jacobian(matrix(x));
}

HexahedronCorners unit_cube() {
  return {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(1, 1, 0), Vector3(0, 1, 0),
          Vector3(0, 0, 1), Vector3(1, 0, 1), Vector3(1, 1, 1), Vector3(0, 1, 1)};
}

HexahedronCorners mapped(const Eigen::Matrix3d& F) {
  HexahedronCorners x = unit_cube();
  for (Vector3& corner : x) corner = F * corner;
  return x;
}

/// Unit cube with every coordinate moved by up to `amplitude`: no face stays plane.
HexahedronCorners distorted_cube(double amplitude, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> moved(-amplitude, amplitude);
  HexahedronCorners x = unit_cube();
  for (Vector3& corner : x)
    corner += Vector3(moved(random), moved(random), moved(random));
  return x;
}

/// Integral of det dx/dxi over the trilinear map, 2x2x2 Gauss points. The determinant
/// is quadratic in each coordinate, the rule exact up to cubic.
double volume_by_quadrature(const HexahedronCorners& x) {
  const HexahedronCorners signs = mapped(2 * Eigen::Matrix3d::Identity());
  double volume = 0;
  for (const Vector3& place : signs) {
    const Vector3 xi = (place - Vector3::Ones()) / std::sqrt(3.);
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < 8; ++i) {
      const Vector3 s = signs[i] - Vector3::Ones();
      const Vector3 f = Vector3::Ones() + s.cwiseProduct(xi);
      const Vector3 gradient(s.x() * f.y() * f.z(), s.y() * f.z() * f.x(),
                             s.z() * f.x() * f.y());
      jacobian += x[i] * gradient.transpose() / 8;
    }
    volume += jacobian.determinant();
  }
  return volume;
}

}  // namespace

// The volume is exact on paper, so that the tolerance is round-off alone.
BOOST_AUTO_TEST_CASE(parallelepiped_has_the_volume_of_its_determinant,
                     *boost::unit_test::tolerance(1e-14)) {
  const Eigen::Matrix3d F =
      (Eigen::Matrix3d() << 2, 0.5, -0.3, 0.1, 1.5, 0.4, -0.2, 0.7, 0.9).finished();
  BOOST_TEST(cell_volume(unit_cube()) == 1);
  BOOST_TEST(cell_volume(mapped(F)) == F.determinant());
}

// Frustum of a square pyramid, h (a^2 + a b + b^2)/3: plane faces that are not parallel.
BOOST_AUTO_TEST_CASE(frustum_has_the_volume_of_the_textbook,
                     *boost::unit_test::tolerance(1e-14)) {
  HexahedronCorners x = mapped(Vector3(3, 3, 5).asDiagonal());
  for (std::size_t i = 4; i < 8; ++i) x[i].head<2>() /= 3;  // top of side 1 below side 3
  BOOST_TEST(cell_volume(x) == 5 * (9 + 3 + 1) / 3.);
}

// Raising one corner of the unit cube by d makes the roof 1 + d xi eta: volume 1 + d/4.
BOOST_AUTO_TEST_CASE(raised_corner_adds_a_quarter_of_its_lift,
                     *boost::unit_test::tolerance(1e-14)) {
  HexahedronCorners x = unit_cube();
  x[6].z() += 0.8;
  BOOST_TEST(cell_volume(x) == 1.2);
}

// The faces are bilinear and non-planar; both ways are exact, so round-off alone.
BOOST_AUTO_TEST_CASE(distorted_hexahedra_agree_with_gauss_quadrature,
                     *boost::unit_test::tolerance(1e-14)) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const HexahedronCorners x = distorted_cube(0.3, seed);
    BOOST_TEST(cell_volume(x) == volume_by_quadrature(x));
  }
}

// The corners are multiples of 2^-30, so adding the shift is exact, and so must be the
// volume. Products of the shifted coordinates would lose 11 digits.
BOOST_AUTO_TEST_CASE(volume_does_not_depend_on_the_place) {
  HexahedronCorners x = distorted_cube(0.3, 5);
  for (Vector3& corner : x) corner = (corner * 0x1p30).array().round() * 0x1p-30;
  const double volume = cell_volume(x);
  for (Vector3& corner : x) corner += Vector3(1024, -2048, 4096);
  BOOST_TEST(cell_volume(x) == volume);
}

BOOST_AUTO_TEST_CASE(volume_is_negative_inside_out, *boost::unit_test::tolerance(1e-14)) {
  HexahedronCorners x = distorted_cube(0.2, 7);
  const double volume = cell_volume(x);
  std::swap_ranges(x.begin(), x.begin() + 4, x.begin() + 4);
  BOOST_TEST(cell_volume(x) < 0);
  BOOST_TEST(cell_volume(x) == -volume);
}

BOOST_AUTO_TEST_CASE(faces_of_a_cube_face_outward) {
  const HexahedronCorners x = unit_cube();
  const Vector3 centre = Vector3::Constant(0.5);
  for (const LocalFace& face : faces(CellType::hexahedron)) {
    const auto corner = [&](std::size_t i) { return x[face[i]]; };
    const Vector3 normal = (corner(2) - corner(0)).cross(corner(3) - corner(1)) / 2;
    const Vector3 middle = (corner(0) + corner(1) + corner(2) + corner(3)) / 4;
    BOOST_TEST(normal.norm() == 1);
    BOOST_TEST(normal.dot(middle - centre) == 0.5);
  }
}

BOOST_AUTO_TEST_CASE(corner_jacobian_of_a_parallelepiped_is_its_determinant,
                     *boost::unit_test::tolerance(1e-14)) {
  const Eigen::Matrix3d F =
      (Eigen::Matrix3d() << 2, 0.5, -0.3, 0.1, 1.5, 0.4, -0.2, 0.7, 0.9).finished();
  BOOST_TEST(smallest_corner_jacobian(mapped(F)) == F.determinant());
  BOOST_TEST(smallest_corner_jacobian(mapped(-F)) == -F.determinant());
}

// Moved by t along the inner diagonal, a corner of the unit cube has the edges
// (1-t, -t, -t) and cyclic: determinant 1 - 3t, its neighbours' stay above it. Beyond
// t = 1/3 the map folds although the volume is still positive.
BOOST_AUTO_TEST_CASE(smallest_corner_jacobian_sees_each_corner,
                     *boost::unit_test::tolerance(1e-14)) {
  for (std::size_t i = 0; i < 8; ++i)
    for (const double t : {0.25, 0.5}) {
      HexahedronCorners x = unit_cube();
      x[i] += t * 2 * (Vector3::Constant(0.5) - x[i]);
      BOOST_TEST(smallest_corner_jacobian(x) == 1 - 3 * t);
      BOOST_TEST(cell_volume(x) > 0);
    }
}

BOOST_AUTO_TEST_CASE(cell_volumes_follow_the_positions,
                     *boost::unit_test::tolerance(1e-14)) {
  std::vector<Vector3> nodes;
  for (const double z : {0., 1., 3.})
    for (std::size_t i = 0; i < 4; ++i)
      nodes.emplace_back(unit_cube()[i] + z * Vector3::UnitZ());
  const std::vector<CellNodes> cells{{0, 1, 2, 3, 4, 5, 6, 7},
                                     {4, 5, 6, 7, 8, 9, 10, 11}};
  const std::vector<double> volumes = cell_volumes(cells, nodes);
  BOOST_TEST(volumes == (std::vector<double>{1, 2}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
