#include <boost/test/unit_test.hpp>

#include "tests/fem_reference/laws.hpp"

// Stresses by hand for Hooke's and St-Venant-Kirchhoff's laws. Exact on paper: the
// tolerance is round-off.

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(closed_forms_test)

namespace {

constexpr double E = young, nu = 0.3;
const auto [lambda, mu] = lame_constants(of_poisson_ratio(nu));
const Constitution linear = hooke(lame_constants(of_poisson_ratio(nu)));
const Constitution st_venant = st_venant_kirchhoff(lame_constants(of_poisson_ratio(nu)));

}  // namespace

BOOST_AUTO_TEST_SUITE(closed_forms, *boost::unit_test::tolerance(1e-12))

BOOST_AUTO_TEST_CASE(hooke_in_uniaxial_strain_has_modulus_lambda_plus_two_mu) {
  constexpr double e = 0.02;
  const Matrix3 P = stress(linear, diagonal(0, 0, e));
  BOOST_TEST(P(2, 2) == (lambda + 2 * mu) * e);
  BOOST_TEST(P(0, 0) == lambda * e);
  BOOST_TEST(P(1, 1) == lambda * e);
  BOOST_TEST(energy(linear, diagonal(0, 0, e)) == (lambda + 2 * mu) / 2 * e * e);
}

BOOST_AUTO_TEST_CASE(
    hooke_bar_contracts_by_poissons_ratio_and_pulls_with_youngs_modulus) {
  constexpr double e = 0.02;
  const Matrix3 P = stress(linear, diagonal(e, -nu * e, -nu * e));
  BOOST_TEST(largest(P - diagonal(E * e, 0, 0)) < 1e-12 * E);
}

BOOST_AUTO_TEST_CASE(hooke_in_shear_has_modulus_mu) {
  Matrix3 H = Matrix3::Zero();
  H(0, 2) = 0.04;
  const Matrix3 P = stress(linear, H);
  BOOST_TEST(P(0, 2) == mu * 0.04);
  BOOST_TEST(P(2, 0) == mu * 0.04);
  BOOST_TEST(energy(linear, H) == mu / 2 * 0.04 * 0.04);
}

// F = diag(1, 1, l): E_zz = (l^2 - 1)/2, S_zz = (lambda + 2 mu) E_zz, P_zz = l S_zz.
BOOST_AUTO_TEST_CASE(st_venant_in_uniaxial_strain_is_cubic_in_the_stretch) {
  constexpr double l = 0.8, strain_zz = (l * l - 1) / 2;
  const Matrix3 P = stress(st_venant, diagonal(0, 0, l - 1));
  BOOST_TEST(P(2, 2) == l * (lambda + 2 * mu) * strain_zz);
  BOOST_TEST(P(0, 0) == lambda * strain_zz);
  BOOST_TEST(energy(st_venant, diagonal(0, 0, l - 1)) ==
             (lambda + 2 * mu) / 2 * strain_zz * strain_zz);
}

// F = I + g e_x (x) e_z: E_xz = g/2, E_zz = g^2/2; P = F S by hand.
BOOST_AUTO_TEST_CASE(st_venant_in_simple_shear_pulls_on_the_plates) {
  constexpr double g = 0.2;
  Matrix3 H = Matrix3::Zero();
  H(0, 2) = g;
  const Matrix3 P = stress(st_venant, H);
  const double S_zz = (lambda + 2 * mu) * g * g / 2;
  BOOST_TEST(P(0, 2) == mu * g + g * S_zz);
  BOOST_TEST(P(2, 0) == mu * g);
  BOOST_TEST(P(2, 2) == S_zz);
  BOOST_TEST(P(0, 0) == lambda * g * g / 2 + g * mu * g);
}

// A bar's force l (l^2 - 1)/2 E, here with nu = 0, is stationary at l = 1/sqrt(3).
BOOST_AUTO_TEST_CASE(st_venant_bar_loses_its_stiffness_at_stretch_0_577) {
  const Constitution corklike = st_venant_kirchhoff(lame_constants(of_poisson_ratio(0)));
  const Matrix9 A = tangent(corklike, diagonal(1 / std::sqrt(3.) - 1, 0, 0));
  BOOST_TEST(std::abs(A(0, 0)) < 1e-12 * E);
}

BOOST_AUTO_TEST_SUITE_END()

// S = lambda tr(E) I + 2 mu E, P = F S.
BOOST_AUTO_TEST_CASE(st_venant_stress_is_hookes_law_in_green_strain) {
  const Matrix3 I = Matrix3::Identity(), F = I + general_gradient();
  const Matrix3 strain = (F.transpose() * F - I) / 2;
  const Matrix3 P = F * (lambda * strain.trace() * I + 2 * mu * strain);
  BOOST_TEST(largest(stress(st_venant, general_gradient()) - P) < 1e-12 * E);
}

BOOST_AUTO_TEST_SUITE_END()
