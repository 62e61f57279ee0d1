#include "tissue/thesis_spring.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "tests/tissue/refusal.hpp"

using namespace springcheck;
using namespace springcheck::tissue;

BOOST_AUTO_TEST_SUITE(thesis_spring_test)

namespace {

// n = 1/2 and p = 3/2: |l - l0|^(1/2) and a hardening of the first power.
const BipowerLaw law{100, 0.5, 0.3, 1.5};
const ThesisSpring printed{law, 0.2, Elongation::in_metres},
    repaired{law, 0.2, Elongation::relative};

}  // namespace

// l0 = 2, l = 2.25: a strain of 1/8, so 1 + .125/.2. Round-off.
BOOST_AUTO_TEST_CASE(tensions_are_those_of_the_equation,
                     *boost::unit_test::tolerance(1e-14)) {
  BOOST_TEST(tension(printed, 3, 2, 2.25) == 3 * 0.5 * 1.625);
  BOOST_TEST(tension(repaired, 3, 2, 2.25) == 3 * 2 * std::sqrt(0.125) * 1.625);
  BOOST_TEST(tension(printed, 3, 2, 1.75) == -3 * 0.5 * 1.625);
  BOOST_TEST(tension(repaired, 3, 2, 1.75) == -tension(repaired, 3, 2, 2.25));
  BOOST_TEST(tension(printed, 3, 2, 2.25, 7, 0.1) == (0.7 + 3 * 0.5) * 1.625);
  BOOST_TEST(tension(printed, 3, 2, 2) == 0.);
}

// The same spring in millimetres: l0 and l a thousand times, k [N/mm] a thousandth. A
// tension is a tension only if it has not changed.
BOOST_AUTO_TEST_CASE(only_the_repaired_one_is_a_force,
                     *boost::unit_test::tolerance(1e-13)) {
  BOOST_TEST(tension(repaired, 3e-3, 2e3, 2.25e3) == tension(repaired, 3, 2, 2.25));
  BOOST_TEST(tension(printed, 3e-3, 2e3, 2.25e3) ==
             tension(printed, 3, 2, 2.25) * std::pow(1000, -0.5));
}

// Differences over a hundred-thousandth of the length are of second order: with strains
// of .05 and more (1e-5/.1)^2 of the slope.
BOOST_AUTO_TEST_CASE(energy_tension_and_stiffness_are_derivatives_of_each_other) {
  for (const ThesisSpring& spring : {printed, repaired})
    for (const double length : {1.2, 1.9, 2.1, 3.}) {
      const double d = 1e-5;
      const auto slope = [&](auto&& of) {
        return (of(length + d) - of(length - d)) / (2 * d);
      };
      BOOST_TEST(tension(spring, 3, 2, length) ==
                     slope([&](double l) { return stored_energy(spring, 3, 2, l); }),
                 boost::test_tools::tolerance(1e-7));
      BOOST_TEST(tangent_stiffness(spring, 3, 2, length) ==
                     slope([&](double l) { return tension(spring, 3, 2, l); }),
                 boost::test_tools::tolerance(1e-7));
    }
  BOOST_TEST(stored_energy(printed, 3, 2, 2) == 0);
  BOOST_TEST(std::isfinite(tangent_stiffness(printed, 3, 2, 2)));
}

BOOST_AUTO_TEST_CASE(limits_are_those_of_table_4_2) {
  BOOST_TEST(hand_fitted_limit("kidney") == 0.07);
  BOOST_TEST(hand_fitted_limit("liver") == 0.45);
  BOOST_TEST(hand_fitted_limit("spleen") == 400.);
  BOOST_TEST(refusal([] { hand_fitted_limit("heart"); }) ==
             "tissue: organ: expected kidney, liver or spleen, got heart");
}

BOOST_AUTO_TEST_CASE(springs_that_cannot_be_are_refused) {
  BOOST_TEST(refusal([] {
               tension({law, 0, Elongation::relative}, 1, 1, 1.1);
             }) ==
             "tissue: strain limit gamma_lim_mss: expected a finite number above 0, got "
             "0");
  BOOST_TEST(refusal([] { tension(printed, 1, 0, 1.1); }) != "none");
  BOOST_TEST(refusal([] {
               tension({{100, 0.5, 0.3, 0.4}, 0.2, Elongation::relative}, 1, 1, 1.1);
             }).starts_with("tissue: exponent p - (1-n) of the hardening"));
}

BOOST_AUTO_TEST_SUITE_END()
