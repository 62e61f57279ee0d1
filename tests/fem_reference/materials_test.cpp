#define BOOST_TEST_MODULE fem_reference_materials
#include "fem_reference/materials.hpp"

#include <Eigen/Geometry>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>

using namespace springcheck;
using namespace springcheck::fem_reference;

namespace {

constexpr double E = 1e4, nu = 0.3;  // Pa, -
constexpr Material material{.young_modulus = E, .poisson_ratio = nu, .density = 1000};
const LameConstants lame = lame_constants(material);
const double lambda = lame.lambda, mu = lame.mu;
const EnergyDensity whole = energy_density(Part::whole, lame);

constexpr std::array laws{Law::hooke, Law::st_venant_kirchhoff};
constexpr std::array parts{Part::whole, Part::shape, Part::volumetric};

/// A displacement gradient with stretch, shear and rotation, all different.
Matrix3 general_gradient() {
  Matrix3 H;
  H << 0.11, -0.23, 0.07, 0.19, -0.16, 0.31, -0.05, 0.13, 0.22;
  return H;
}

Matrix3 diagonal(double x, double y, double z) {
  return Vector3(x, y, z).asDiagonal();
}

double largest(const Matrix3& matrix) {
  return matrix.cwiseAbs().maxCoeff();
}

}  // namespace

// Closed forms: the tolerance is round-off.
BOOST_AUTO_TEST_SUITE(closed_forms, *boost::unit_test::tolerance(1e-12))

BOOST_AUTO_TEST_CASE(hooke_in_uniaxial_strain_has_modulus_lambda_plus_two_mu) {
  constexpr double e = 0.02;
  const Matrix3 P = stress(Law::hooke, whole, diagonal(0, 0, e));
  BOOST_TEST(P(2, 2) == (lambda + 2 * mu) * e);
  BOOST_TEST(P(0, 0) == lambda * e);
  BOOST_TEST(P(1, 1) == lambda * e);
  BOOST_TEST(energy(Law::hooke, whole, diagonal(0, 0, e)) ==
             (lambda + 2 * mu) / 2 * e * e);
}

BOOST_AUTO_TEST_CASE(
    hooke_bar_contracts_by_poissons_ratio_and_pulls_with_youngs_modulus) {
  constexpr double e = 0.02;
  const Matrix3 P = stress(Law::hooke, whole, diagonal(e, -nu * e, -nu * e));
  BOOST_TEST(largest(P - diagonal(E * e, 0, 0)) < 1e-12 * E);
}

BOOST_AUTO_TEST_CASE(hooke_in_shear_has_modulus_mu) {
  Matrix3 H = Matrix3::Zero();
  H(0, 2) = 0.04;
  const Matrix3 P = stress(Law::hooke, whole, H);
  BOOST_TEST(P(0, 2) == mu * 0.04);
  BOOST_TEST(P(2, 0) == mu * 0.04);
  BOOST_TEST(energy(Law::hooke, whole, H) == mu / 2 * 0.04 * 0.04);
}

// F = diag(1, 1, l): E_zz = (l^2 - 1)/2, S_zz = (lambda + 2 mu) E_zz, P_zz = l S_zz.
BOOST_AUTO_TEST_CASE(st_venant_in_uniaxial_strain_is_cubic_in_the_stretch) {
  constexpr double l = 0.8, strain_zz = (l * l - 1) / 2;
  const Matrix3 H = diagonal(0, 0, l - 1);
  const Matrix3 P = stress(Law::st_venant_kirchhoff, whole, H);
  BOOST_TEST(P(2, 2) == l * (lambda + 2 * mu) * strain_zz);
  BOOST_TEST(P(0, 0) == lambda * strain_zz);
  BOOST_TEST(energy(Law::st_venant_kirchhoff, whole, H) ==
             (lambda + 2 * mu) / 2 * strain_zz * strain_zz);
}

// F = I + g e_x (x) e_z: E_xz = g/2, E_zz = g^2/2; P = F S by hand.
BOOST_AUTO_TEST_CASE(st_venant_in_simple_shear_pulls_on_the_plates) {
  constexpr double g = 0.2;
  Matrix3 H = Matrix3::Zero();
  H(0, 2) = g;
  const Matrix3 P = stress(Law::st_venant_kirchhoff, whole, H);
  const double S_zz = (lambda + 2 * mu) * g * g / 2;
  BOOST_TEST(P(0, 2) == mu * g + g * S_zz);
  BOOST_TEST(P(2, 0) == mu * g);
  BOOST_TEST(P(2, 2) == S_zz);
  BOOST_TEST(P(0, 0) == lambda * g * g / 2 + g * mu * g);
}

// A bar's force l (l^2 - 1)/2 E, here with nu = 0, is stationary at l = 1/sqrt(3).
BOOST_AUTO_TEST_CASE(st_venant_bar_loses_its_stiffness_at_stretch_0_577) {
  const EnergyDensity corklike{.a = E / 2, .b = 0, .p = 0};
  const Matrix9 A =
      tangent(Law::st_venant_kirchhoff, corklike, diagonal(1 / std::sqrt(3.) - 1, 0, 0));
  BOOST_TEST(std::abs(A(0, 0)) < 1e-12 * E);
}

BOOST_AUTO_TEST_CASE(
    st_venant_energy_does_not_feel_a_rotation_and_its_stress_turns_along) {
  const Matrix3 R =
      Eigen::AngleAxisd(2.1, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
  const Matrix3 H = general_gradient(), I = Matrix3::Identity();
  const Matrix3 turned = R * (I + H) - I;
  BOOST_TEST(energy(Law::st_venant_kirchhoff, whole, turned) ==
             energy(Law::st_venant_kirchhoff, whole, H));
  const Matrix3 P = stress(Law::st_venant_kirchhoff, whole, H);
  BOOST_TEST(largest(stress(Law::st_venant_kirchhoff, whole, turned) - R * P) <
             1e-12 * largest(P));
}

BOOST_AUTO_TEST_CASE(shape_and_volumetric_parts_sum_to_the_law) {
  const EnergyDensity shape = energy_density(Part::shape, lame);
  const EnergyDensity volumetric = energy_density(Part::volumetric, lame);
  const Matrix3 H = general_gradient();
  for (const Law law : laws) {
    BOOST_TEST(energy(law, shape, H) + energy(law, volumetric, H) ==
               energy(law, whole, H));
    const Matrix3 P = stress(law, whole, H);
    BOOST_TEST(largest(stress(law, shape, H) + stress(law, volumetric, H) - P) <
               1e-12 * largest(P));
  }
}

BOOST_AUTO_TEST_CASE(shape_part_does_not_feel_a_change_of_volume) {
  BOOST_TEST(std::abs(energy(Law::hooke, energy_density(Part::shape, lame),
                             diagonal(0.1, 0.1, 0.1))) < 1e-12 * E);
}

BOOST_AUTO_TEST_SUITE_END()

// Central differences with step d err by d^2/6 of the third derivative and by 1e-16/d of
// round-off: about 1e-10 of the stress at d = 1e-5. St-Venant's energy is quartic and
// Hooke's quadratic, so the third derivatives are of the size of the moduli.
BOOST_AUTO_TEST_CASE(stress_and_tangent_are_derivatives_of_the_energy) {
  constexpr double d = 1e-5;
  for (const Law law : laws)
    for (const Part part : parts)
      for (const double mean_stress : {0., 700.}) {
        EnergyDensity psi = energy_density(part, lame);
        psi.p = mean_stress;
        const Matrix3 H = general_gradient();
        const Matrix3 P = stress(law, psi, H);
        const Matrix9 A = tangent(law, psi, H);
        const Matrix3 D = trace_derivative(law, H);
        for (int L = 0; L < 3; ++L)
          for (int k = 0; k < 3; ++k) {
            Matrix3 more = H, less = H;
            more(k, L) += d;
            less(k, L) -= d;
            const double slope =
                (energy(law, psi, more) - energy(law, psi, less)) / (2 * d);
            BOOST_TEST(std::abs(slope - P(k, L)) < 1e-8 * E);
            const Matrix3 change =
                (stress(law, psi, more) - stress(law, psi, less)) / (2 * d);
            const Matrix3 column = A.col(k + 3 * L).reshaped(3, 3);
            BOOST_TEST(largest(change - column) < 1e-8 * E);
            const double trace_slope =
                (strain(law, more).trace() - strain(law, less).trace()) / (2 * d);
            BOOST_TEST(std::abs(trace_slope - D(k, L)) < 1e-8);
          }
      }
}

// The digits of a tiny displacement gradient survive (F = I + H would keep four of them).
BOOST_AUTO_TEST_CASE(stress_of_a_tiny_strain_keeps_its_digits,
                     *boost::unit_test::tolerance(1e-11)) {
  const Matrix3 P = stress(Law::st_venant_kirchhoff, whole, diagonal(0, 0, 1e-12));
  BOOST_TEST(P(2, 2) == (lambda + 2 * mu) * 1e-12);
}
