#include "tissue/bipower_law.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "tests/referee/figures.hpp"
#include "tests/tissue/refusal.hpp"
#include "tissue/rheometer.hpp"

using namespace springcheck;
using namespace springcheck::tissue;

BOOST_AUTO_TEST_SUITE(bipower_law_test)

namespace {

// Quadratures there go to 1e-12, those of discs to 1e-10.
constexpr double of_the_referee = 1e-9;

const BipowerLaw liver = law_of_organ("liver");

}  // namespace

BOOST_AUTO_TEST_CASE(stresses_at_constant_rate_are_eq_4_1_integrated,
                     *boost::unit_test::tolerance(of_the_referee)) {
  const auto rows = referee::rows("tissue_at_rate");
  BOOST_TEST(rows.size() == 90U);
  for (const referee::Row& row : rows) {
    const ShearStress stress = constant_rate_stress(
        law_of_organ(row.text("organ")), row.number("strain"), row.number("rate"));
    BOOST_TEST(stress.linear == row.number("linear"));
    BOOST_TEST(stress.hardening == row.number("hardening"));
  }
}

BOOST_AUTO_TEST_CASE(relaxation_after_ramps_and_steps_is_eq_4_1_integrated,
                     *boost::unit_test::tolerance(of_the_referee)) {
  const auto rows = referee::rows("tissue_held");
  BOOST_TEST(rows.size() == 384U);
  for (const referee::Row& row : rows) {
    const BipowerLaw law = law_of_organ(row.text("organ"));
    const double strain = row.number("strain"), time = row.number("held");
    const ShearStress stress =
        row.text("rate") == "inf"
            ? ideal_step_stress(law, strain, time)
            : ramp_and_hold_stress(law, strain, row.number("rate"), time);
    BOOST_TEST(stress.total() == row.number("stress"));
  }
}

BOOST_AUTO_TEST_CASE(small_oscillations_have_the_law_s_fourier_integral,
                     *boost::unit_test::tolerance(of_the_referee)) {
  const auto rows = referee::rows("tissue_oscillating");
  BOOST_TEST(rows.size() == 15U);
  for (const referee::Row& row : rows) {
    const ComplexModulus moduli =
        small_oscillation(law_of_organ(row.text("organ")), row.number("frequency"));
    BOOST_TEST(moduli.storage == row.number("storage"));
    BOOST_TEST(moduli.loss == row.number("loss"));
    BOOST_TEST(moduli.loss_tangent() == row.number("loss") / row.number("storage"));
  }
}

BOOST_AUTO_TEST_CASE(torques_of_discs_are_those_of_their_rings,
                     *boost::unit_test::tolerance(of_the_referee)) {
  const auto rows = referee::rows("tissue_between_discs");
  BOOST_TEST(rows.size() == 90U);
  for (const referee::Row& row : rows) {
    const double radius = row.number("radius"), torque = row.number("torque");
    BOOST_TEST(disc_torque(law_of_organ(row.text("organ")), row.number("strain"),
                           row.number("rate"), radius) == torque);
    BOOST_TEST(apparent_stress(torque, radius) ==
               2 * torque / (std::numbers::pi * std::pow(radius, 3)));
  }
}

BOOST_AUTO_TEST_CASE(relaxation_begins_where_the_ramp_ended,
                     *boost::unit_test::tolerance(1e-9)) {
  for (const Organ& organ : organs())
    for (const double strain : {0.01, 1.}) {
      const ShearStress ramp = constant_rate_stress(organ.law, strain, 0.133);
      const ShearStress held = ramp_and_hold_stress(organ.law, strain, 0.133, 0);
      BOOST_TEST(held.linear == ramp.linear);
      BOOST_TEST(held.hardening == ramp.hardening);
    }
}

// A ramp of 1 ns seen after 1 s: 1e-9 of the time.
BOOST_AUTO_TEST_CASE(fast_ramps_are_steps, *boost::unit_test::tolerance(1e-8)) {
  const ShearStress step = ideal_step_stress(liver, 0.8, 1);
  const ShearStress ramp = ramp_and_hold_stress(liver, 0.8, 0.8e9, 1);
  BOOST_TEST(ramp.linear == step.linear);
  BOOST_TEST(ramp.hardening == step.hardening);
  BOOST_TEST(hardened_strain(liver, -0.8) == -hardened_strain(liver, 0.8));
}

BOOST_AUTO_TEST_CASE(no_strain_gives_no_stress) {
  BOOST_TEST(constant_rate_stress(liver, 0, 1).total() == 0);
  BOOST_TEST(ramp_and_hold_stress(liver, 0, 1, 1).total() == 0);
  BOOST_TEST(disc_torque(liver, 0, 1, 0.01) == 0);
}

namespace {

std::string refusal_of(const BipowerLaw& law) {
  return refusal([&] { check(law); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_cannot_be_is_refused_with_its_range) {
  BOOST_TEST(refusal_of(liver) == "none");
  BOOST_TEST(refusal_of({-1, 0.1, 0.4, 4}) ==
             "tissue: consistency K [Pa s^n]: expected a finite number above 0, got -1");
  BOOST_TEST(refusal_of({1, 0, 0.4, 4}) ==
             "tissue: linear index n: expected a number above 0 and below 1, got 0");
  BOOST_TEST(refusal_of({1, 1, 0.4, 4}) ==
             "tissue: linear index n: expected a number above 0 and below 1, got 1");
  BOOST_TEST(refusal_of({1, NAN, 0.4, 4}) ==
             "tissue: linear index n: expected a number above 0 and below 1, got nan");
  BOOST_TEST(refusal_of({1, 0.1, 0, 4}) ==
             "tissue: linear limit gamma_lim: expected a finite number above 0, got 0");
  BOOST_TEST(refusal_of({1, 0.1, 0.4, INFINITY}) ==
             "tissue: hardening index p: expected a finite number above 0, got inf");
  BOOST_TEST(refusal([] { law_of_organ("brain"); }) ==
             "tissue: organ: expected one of liver, kidney, spleen, got 'brain'");
  BOOST_TEST(refusal([] { constant_rate_stress(liver, 0.1, 0); }) ==
             "tissue: strain rate [1/s]: expected a finite number above 0, got 0");
  BOOST_TEST(refusal([] { constant_rate_stress(liver, -0.1, 1); }) ==
             "tissue: strain: expected a finite number, 0 or above, got -0.1");
  BOOST_TEST(refusal([] { ramp_and_hold_stress(liver, 0.1, 1, -2); }) ==
             "tissue: time held [s]: expected a finite number, 0 or above, got -2");
  BOOST_TEST(refusal([] { ideal_step_stress(liver, 0.1, 0); }) ==
             "tissue: time [s]: expected a finite number above 0, got 0");
  BOOST_TEST(
      refusal([] { small_oscillation(liver, 0); }) ==
      "tissue: angular frequency [rad/s]: expected a finite number above 0, got 0");
  BOOST_TEST(refusal([] { disc_torque(liver, 0.1, 1, 0); }) ==
             "tissue: radius of the disc [m]: expected a finite number above 0, got 0");
}

BOOST_AUTO_TEST_SUITE_END()
