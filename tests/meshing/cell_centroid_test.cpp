#include <boost/test/unit_test.hpp>
#include <cmath>

#include "meshing/cell_geometry.hpp"
#include "meshing/generators/generate_block.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(cell_centroid_test)

namespace {

constexpr double round_off = 1e-14;

CornerPositions frustum() {
  CornerPositions x(3, 8);
  x << -1, 1, 1, -1, 0, 0.5, 0.5, 0,  //
      -1, -1, 1, 1, 0, 0, 0.5, 0.5,   //
      0, 0, 0, 0, 3, 3, 3, 3;
  return x;
}

}  // namespace

// By hand, the centroid is a quarter of the way from the base of a tetrahedron and a
// pyramid, and the middle of a prism and a box.
BOOST_AUTO_TEST_CASE(centroids_of_regular_cells_are_those_of_the_textbook) {
  CornerPositions x(3, 4);
  x << 1, 5, 1, 1, 2, 2, 6, 2, 3, 3, 3, 7;
  BOOST_TEST((cell_centroid(x) - Vector3(2, 3, 4)).norm() < round_off);
  x.resize(3, 5);
  x << 0, 4, 4, 0, 2, 0, 0, 4, 4, 2, 0, 0, 0, 0, 8;
  BOOST_TEST((cell_centroid(x) - Vector3(2, 2, 2)).norm() < round_off);
  x.resize(3, 6);
  x << 0, 3, 0, 0, 3, 0, 0, 0, 6, 0, 0, 6, 0, 0, 0, 2, 2, 2;
  BOOST_TEST((cell_centroid(x) - Vector3(1, 2, 1)).norm() < round_off);
  x.resize(3, 8);
  x << 0, 2, 2, 0, 0, 2, 2, 0, 0, 0, 4, 4, 0, 0, 4, 4, 0, 0, 0, 0, 6, 6, 6, 6;
  BOOST_TEST((cell_centroid(x) - Vector3(1, 2, 3)).norm() < round_off);
}

// The frustum has the sections s^2, s = 2 - z/2, whose middle wanders from 0 to 1/4: V =
// int s^2, and int z s^2 of both moments, are computed by hand.
BOOST_AUTO_TEST_CASE(centroid_of_a_leaning_frustum_is_that_of_its_sections) {
  const Vector3 c = cell_centroid(frustum());
  const double V = 21. / 4;
  BOOST_TEST(std::abs(cell_volume(frustum()) - V) < round_off);
  const double first = 81. / 16;
  BOOST_TEST(std::abs(c.z() - first / V) < round_off);
  BOOST_TEST(std::abs(c.x() - first / V / 12) < round_off);
}

// Cells of warped faces that fill a box share its first moment: what one gains at a face
// the other loses. The tolerance is round-off of 400 cells.
BOOST_AUTO_TEST_CASE(centroids_of_the_parts_make_that_of_the_whole) {
  for (const auto& [name, pattern, description] : cell_patterns()) {
    if (!keeps_grid(pattern)) continue;
    const Mesh mesh = generate_block(
        {.size = {3, 4, 2}, .cells = {3, 4, 2}, .pattern = pattern, .distortion = 0.2});
    Vector3 moment = Vector3::Zero();
    for (std::size_t c = 0; c < mesh.cells().size(); ++c)
      moment +=
          mesh.cell_volumes()[c] * cell_centroid(corners(mesh.cells()[c], mesh.nodes()));
    BOOST_TEST((moment / 24 - Vector3(1.5, 2, 1)).norm() < 1e-13, name);
  }
}

// The centroid of one cell of warped faces is found by a product of Gauss points of
// fourth degree over the trilinear map, whose integrand of the first moment is of no
// higher one.
BOOST_AUTO_TEST_CASE(centroid_of_a_warped_hexahedron_is_that_of_the_trilinear_map) {
  std::srand(3);  // Eigen's Random draws from rand()
  CornerPositions x(3, 8);
  x << 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1;
  const CornerPositions X = x;
  x += 0.2 * Eigen::Matrix<double, 3, 8>::Random();
  const double root = std::sqrt(0.6);
  const std::array<std::pair<double, double>, 3> points{
      {{(1 - root) / 2, 5. / 18}, {0.5, 8. / 18}, {(1 + root) / 2, 5. / 18}}};
  Vector3 moment = Vector3::Zero();
  double volume = 0;
  for (const auto& [r, wr] : points)
    for (const auto& [s, ws] : points)
      for (const auto& [t, wt] : points) {
        Vector3 place = Vector3::Zero();
        Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
        for (Eigen::Index a = 0; a < 8; ++a) {
          const double fr = X(0, a) == 1 ? r : 1 - r, fs = X(1, a) == 1 ? s : 1 - s,
                       ft = X(2, a) == 1 ? t : 1 - t;
          const Vector3 slope(2 * X(0, a) - 1, 2 * X(1, a) - 1, 2 * X(2, a) - 1);
          place += fr * fs * ft * x.col(a);
          J += x.col(a) *
               Vector3(slope.x() * fs * ft, fr * slope.y() * ft, fr * fs * slope.z())
                   .transpose();
        }
        const double weight = wr * ws * wt * J.determinant();
        moment += weight * place;
        volume += weight;
      }
  BOOST_TEST((cell_centroid(x) - moment / volume).norm() < round_off);
}

BOOST_AUTO_TEST_SUITE_END()
