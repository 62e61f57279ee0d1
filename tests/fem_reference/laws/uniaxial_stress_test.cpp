#include <Eigen/LU>
#include <array>
#include <boost/test/unit_test.hpp>

#include "fem_reference/laws/uniaxial_stress.hpp"

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(uniaxial_stress_test)

namespace {

CauchyBorn law_of(double nu, LatticeDirection direction) {
  return cauchy_born({.young_modulus = 10e3, .poisson_ratio = nu, .density = 1000},
                     {.direction = direction});
}

Matrix3 stress(const CauchyBorn& law, const Matrix3& H) {
  const Dilatation t = law.dilatation(H);
  return law.stress(H) + law.volumetric_energy(t.value).first * t.first;
}

constexpr std::array directions{LatticeDirection::d100, LatticeDirection::d110,
                                LatticeDirection::d111};

}  // namespace

// The sides are free: no stress but P_zz, against a modulus of 1e4 Pa. Round-off.
BOOST_AUTO_TEST_CASE(only_the_axis_carries_stress) {
  for (const double nu : {0., 0.25, 0.499})
    for (const LatticeDirection direction : directions)
      for (const double strain : {-0.2, -0.05, 0.15}) {
        const CauchyBorn law = law_of(nu, direction);
        const Matrix3 H = uniaxial_stress_state(law, strain);
        Matrix3 P = stress(law, H);
        BOOST_TEST(H(2, 2) == strain);
        BOOST_TEST(P(2, 2) * strain > 0);
        P(2, 2) = 0;
        BOOST_TEST(P.norm() < 1e-6 * 1e4);
      }
}

// Small strain: E and nu, whichever way the lattice is turned. Tolerance: the strain.
BOOST_AUTO_TEST_CASE(small_strain_gives_the_isotropic_material,
                     *boost::unit_test::tolerance(1e-4)) {
  constexpr double strain = 1e-5;
  for (const double nu : {0.1, 0.25, 0.45})
    for (const LatticeDirection direction : directions) {
      const CauchyBorn law = law_of(nu, direction);
      const Matrix3 H = uniaxial_stress_state(law, strain);
      BOOST_TEST(H(0, 0) == -nu * strain);
      BOOST_TEST(H(1, 1) == -nu * strain);
      BOOST_TEST(stress(law, H)(2, 2) == 10e3 * strain);
    }
}

BOOST_AUTO_TEST_CASE(the_rotation_is_one) {
  for (const LatticeDirection direction : directions) {
    const Matrix3 R = lattice_to_body(direction);
    BOOST_TEST((R * R.transpose() - Matrix3::Identity()).norm() < 1e-15);
    BOOST_TEST(std::abs(R.determinant() - 1) < 1e-15);
  }
}

BOOST_AUTO_TEST_SUITE_END()
