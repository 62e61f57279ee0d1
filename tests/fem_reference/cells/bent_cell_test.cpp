#include <boost/test/unit_test.hpp>
#include <cmath>

#include "fem_reference/cells/cell.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/cells/one_cell.hpp"
#include "tests/fem_reference/laws.hpp"

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(bent_cell_test)

namespace {

/// u_x = c x z about the centre: H has c z at xx and c x at xz.
constexpr double c = 6;  // 1/m, strains of up to .15
Vector3 bent(const Vector3& X) {
  return {c * (X.x() - edge / 2) * (X.z() - edge / 2), 0, 0};
}

}  // namespace

// eps_xx = c z, eps_xz = c x/2 and int x^2 = int z^2 = h^5/12. The mean dilatation is
// zero: a cell that takes one dilatation is spared K. The integrals are exact: the
// tolerance is round-off.
BOOST_AUTO_TEST_CASE(one_element_in_bending_has_its_closed_form_energy,
                     *boost::unit_test::tolerance(1e-12)) {
  const auto [lambda, mu] = lame_constants(of_poisson_ratio(0.3));
  const double inertia = c * c * std::pow(edge, 5) / 12;
  for (const Element element : elements) {
    const OneCell cell(cube(1), element);
    const auto energy_of = [&](DilatationTaken taken) {
      return cell_state(cell_law(Law::hooke, taken), cell.shape(), cell.at_nodes(bent))
          .energy;
    };
    BOOST_TEST(energy_of(DilatationTaken::at_points) ==
               inertia * (1.5 * mu + lambda / 2));
    BOOST_TEST(energy_of(DilatationTaken::cell_mean) == inertia * (1.5 * mu - mu / 3));
    BOOST_TEST(energy_of(DilatationTaken::of_mean_gradient) ==
               inertia * (1.5 * mu - mu / 3));
  }
}

// A right prism on the half square x + y < h. There u_x = c x z about the centroid is of
// the element's own kind, int x^2 dA = h^4/36 and int z^2 = h^3/12. The integrals are
// exact: the tolerance is round-off.
BOOST_AUTO_TEST_CASE(one_prism_in_bending_has_its_closed_form_energy,
                     *boost::unit_test::tolerance(1e-12)) {
  const auto [lambda, mu] = lame_constants(of_poisson_ratio(0.3));
  constexpr double h = edge;
  const OneCell cell(
      mesh_of({{0, 0, 0}, {h, 0, 0}, {0, h, 0}, {0, 0, h}, {h, 0, h}, {0, h, h}},
              {0, 1, 2, 3, 4, 5}),
      Element::q1);
  const CellVectors u = cell.at_nodes([](const Vector3& X) -> Vector3 {
    return {c * (X.x() - h / 3) * (X.z() - h / 2), 0, 0};
  });
  const CellState state =
      cell_state(cell_law(Law::hooke, DilatationTaken::at_points), cell.shape(), u);
  const double along_z = std::pow(h, 5) / 24, along_x = std::pow(h, 5) / 36;
  BOOST_TEST(state.energy == c * c * ((mu + lambda / 2) * along_z + mu / 2 * along_x));
  BOOST_TEST(gradient_square(cell.shape(), u) == c * c * (along_z + along_x));
}

// det F = 1 + c z, smallest at the lower of the Gauss points z = +-h/(2 sqrt(3)) and 0 or
// +-sqrt(3/5) h/2; int |H|^2 = c^2 int (x^2 + z^2), int det F = V. The tolerance is
// round-off.
BOOST_AUTO_TEST_CASE(cell_reports_the_smallest_jacobian_of_its_gauss_points,
                     *boost::unit_test::tolerance(1e-12)) {
  for (const Element element : elements) {
    const OneCell cell(cube(1), element);
    const CellState state = cell_state(cell_law(Law::hencky, DilatationTaken::at_points),
                                       cell.shape(), cell.at_nodes(bent));
    const double lowest = element == Element::q2 ? std::sqrt(0.6) : std::sqrt(1. / 3);
    BOOST_TEST(state.smallest_jacobian == 1 - c * edge / 2 * lowest);
    BOOST_TEST(gradient_square(cell.shape(), cell.at_nodes(bent)) ==
               c * c * std::pow(edge, 5) / 6);
    BOOST_TEST(deformed_volume(cell.shape(), cell.at_nodes(bent)) == volume);
  }
}

// tr E = c z + c^2 (x^2 + z^2)/2: its mean is c^2 h^2/12, though the mean gradient is
// zero. At the points of q2 (exact to fifth degree) its square gives the integral c^2
// h^2/12 + c^4/4 (h^4/40 + h^4/72) per volume. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(st_venant_element_in_bending_tells_the_places_apart,
                     *boost::unit_test::tolerance(1e-11)) {
  const OneCell cell(cube(1), Element::q2);
  const double K = young / (3 * (1 - 2 * 0.3)), s = c * c * edge * edge;
  const auto energy_of = [&](DilatationTaken taken) {
    return cell_state(cell_law(Law::st_venant_kirchhoff, taken), cell.shape(),
                      cell.at_nodes(bent))
        .energy;
  };
  const double shape_part = energy_of(DilatationTaken::of_mean_gradient);
  BOOST_TEST(energy_of(DilatationTaken::cell_mean) - shape_part ==
             volume * K / 2 * (s / 12) * (s / 12));
  BOOST_TEST(energy_of(DilatationTaken::at_points) - shape_part ==
             volume * K / 2 * (s / 12 + s * s / 4 * (1. / 40 + 1. / 72)));
}

BOOST_AUTO_TEST_SUITE_END()
