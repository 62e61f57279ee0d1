#include "mss/networks/stiffness.hpp"
#include "tests/mss/networks/axial_modulus.hpp"

#include <boost/test/unit_test.hpp>

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(stiffness_test)

namespace {

void check(const LatticeStiffness& k, const LatticeStiffness& expected) {
  BOOST_TEST(k.edge == expected.edge);
  BOOST_TEST(k.face_diagonal == expected.face_diagonal);
  BOOST_TEST(k.inner_diagonal == expected.inner_diagonal);
}

}  // namespace

// All formulas are evaluated in a few operations: the tolerances are round-off.

// The values are computed by hand from k_c = 3 mu h/(3A+4), k_f = A k_c, k_e = k_f +
// 8/3 k_c; A is exact in binary, and so are 3A+4 and the rest at A = 4.
BOOST_AUTO_TEST_CASE(shear_modulus_form_has_the_values_computed_by_hand,
                     *boost::unit_test::tolerance(1e-15)) {
  check(shear_modulus_form(1, 1, 0), {2, 0, 3. / 4});
  check(shear_modulus_form(1, 1, 0.5), {19. / 11, 3. / 11, 6. / 11});
  check(shear_modulus_form(1, 1, 1), {11. / 7, 3. / 7, 3. / 7});
  check(shear_modulus_form(1, 1, 4), {5. / 4, 3. / 4, 3. / 16});
}

BOOST_AUTO_TEST_CASE(stiffness_grows_with_modulus_and_cell_edge,
                     *boost::unit_test::tolerance(1e-15)) {
  check(shear_modulus_form(2800, 0.005, 1), {22, 6, 6});
}

// Golec 2018, Eq. 5.12 with E = 1: k_c = 6/(5 (3A+4)).
BOOST_AUTO_TEST_CASE(young_modulus_form_has_the_values_computed_by_hand,
                     *boost::unit_test::tolerance(1e-15)) {
  check(young_modulus_form(1, 1, 0), {4. / 5, 0, 3. / 10});
  check(young_modulus_form(1, 1, 1), {22. / 35, 6. / 35, 6. / 35});
}

BOOST_AUTO_TEST_CASE(both_forms_agree_at_a_quarter_and_nowhere_else) {
  for (const double nu : {-0.5, 0., 0.2, 0.25, 0.3, 0.499}) {
    const double mu =
        lame_constants({.young_modulus = 1e4, .poisson_ratio = nu, .density = 1}).mu;
    const double ratio =
        young_modulus_form(1e4, 0.005, 1).edge / shear_modulus_form(mu, 0.005, 1).edge;
    BOOST_TEST(ratio == 0.8 * (1 + nu), boost::test_tools::tolerance(1e-15));
    BOOST_TEST((std::abs(ratio - 1) < 1e-15) == (nu == 0.25));
  }
}

// By hand: k_ed = E h (4 nu + 1)/(8 (1 + nu)), and four of them lie at an edge.
BOOST_AUTO_TEST_CASE(baudet_stiffness_has_the_values_computed_by_hand,
                     *boost::unit_test::tolerance(1e-15)) {
  check(baudet_stiffness(1, 0, 1), {1. / 2, 0, 3. / 8});
  check(baudet_stiffness(8000, 0.5, 0.005), {40, 0, 10});
  check(baudet_stiffness(1, -0.25, 1), {0, 0, 1. / 2});
}

BOOST_AUTO_TEST_CASE(baudet_is_the_lattice_without_face_diagonals_at_a_quarter,
                     *boost::unit_test::tolerance(1e-15)) {
  check(baudet_stiffness(1e4, 0.25, 0.005), shear_modulus_form(0.4 * 1e4, 0.005, 0));
}

// By hand: with h = 1 C_11 and C_12 are 4 and 2, E = 4 - 8/6; with kappa = 4 they are 8
// and 6, E = 8 - 72/14. Of the unstable lattices, the first has C_11 = 19, C_12 = -11 and
// E = 19 - 242/8 < 0, the second has -80 and -90, and its E would be positive.
BOOST_AUTO_TEST_CASE(axial_modulus_has_the_values_computed_by_hand,
                     *boost::unit_test::tolerance(1e-14)) {
  const LatticeStiffness k{.edge = 4. / 3, .face_diagonal = 2. / 3, .inner_diagonal = 1};
  BOOST_TEST(axial_modulus({k, 0}, 1) == 8. / 3);
  BOOST_TEST(axial_modulus({k, 4}, 1) == 20. / 7);
  BOOST_TEST(axial_modulus({k, 8}, 0.5) == 2 * 20. / 7);
  BOOST_TEST(axial_modulus({{.edge = 3, .face_diagonal = 0, .inner_diagonal = 0}, 0},
                           0.1) == 30);
  BOOST_TEST(axial_modulus({{0, 3, 0}, -41}, 0.1) == 0);
  BOOST_TEST(axial_modulus({{0, 1, 0}, -100}, 0.1) == 0);
}

// kappa of nu = .499 is 333 times mu, and E a difference of such numbers.
BOOST_AUTO_TEST_CASE(axial_modulus_of_the_thesis_s_lattice_is_young_s_modulus,
                     *boost::unit_test::tolerance(1e-11)) {
  for (const double nu : {-0.5, 0., 0.25, 0.4, 0.499})
    for (const double A : {0., 1., 3.}) {
      const Material material{.young_modulus = 1e4, .poisson_ratio = nu, .density = 1};
      const LatticeConstants lattice{
          shear_modulus_form(lame_constants(material).mu, 0.005, A),
          volume_correction_modulus(material)};
      BOOST_TEST(axial_modulus(lattice, 0.005) == 1e4, "nu = " << nu << ", A = " << A);
    }
}

// The values are computed by hand from E (4 nu - 1)/(2 (1 + nu)(1 - 2 nu)). They are also
// compared with the identity lambda - mu, whose terms cancel by up to a factor of 10
// here.
BOOST_AUTO_TEST_CASE(volume_correction_supplies_lambda_minus_mu,
                     *boost::unit_test::tolerance(1e-13)) {
  struct Row {
    double nu, kappa;
  };
  for (const Row& row :
       {Row{-0.5, -3. / 2}, Row{0, -1. / 2}, Row{0.25, 0}, Row{0.4, 15. / 14}}) {
    const Material material{.young_modulus = 1, .poisson_ratio = row.nu, .density = 1};
    BOOST_TEST(volume_correction_modulus(material) == row.kappa);
  }
  for (const double nu : {-0.9, -0.25, 0.1, 0.3, 0.45, 0.499}) {
    const Material material{.young_modulus = 1e4, .poisson_ratio = nu, .density = 1};
    const auto [lambda, mu] = lame_constants(material);
    BOOST_TEST(volume_correction_modulus(material) == lambda - mu);
  }
}

BOOST_AUTO_TEST_SUITE_END()
