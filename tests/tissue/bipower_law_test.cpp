#include "tissue/bipower_law.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/tissue/reference_rows.hpp"
#include "tests/tissue/refusal.hpp"
#include "tissue/rheometer.hpp"

using namespace springcheck;
using namespace springcheck::tissue;

BOOST_AUTO_TEST_SUITE(bipower_law_test)

namespace {

// The files have eight digits; one unit of the last is up to 1e-7.
constexpr double of_the_files = 2e-7;

const BipowerLaw liver = law_of_organ("liver");

double integral(const std::function<double(double)>& f, double from, double to) {
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, from, to, 15,
                                                                       1e-12);
}

}  // namespace

BOOST_AUTO_TEST_CASE(stresses_at_constant_rate_are_the_prototypes,
                     *boost::unit_test::tolerance(of_the_files)) {
  const auto rows = reference_rows("bipower_stress.csv");
  BOOST_TEST(rows.size() == 171U);
  for (const ReferenceRow& row : rows) {
    const BipowerLaw law = row.law();
    BOOST_TEST(law.consistency == row.number("K_Pa_s^n"));
    BOOST_TEST(law.linear_index == row.number("n"));
    BOOST_TEST(law.linear_limit == row.number("gamma_lim"));
    BOOST_TEST(law.hardening_index == row.number("p"));
    const ShearStress stress =
        constant_rate_stress(law, row.number("gamma"), row.number("rate_1/s"));
    BOOST_TEST(stress.linear == row.number("linear_part_Pa"));
    BOOST_TEST(stress.total() == row.number("stress_Pa"));
    // There it is the rest of the whole, whose round-off it has.
    const double hardening = row.number("hardening_part_Pa");
    BOOST_TEST(std::abs(stress.hardening - hardening) <
               of_the_files * hardening + 1e-15 * stress.total());
  }
}

BOOST_AUTO_TEST_CASE(relaxation_after_ramps_and_steps_is_the_prototypes,
                     *boost::unit_test::tolerance(of_the_files)) {
  const auto rows = reference_rows("relaxation.csv");
  BOOST_TEST(rows.size() == 384U);
  for (const ReferenceRow& row : rows) {
    const double strain = row.number("gamma0");
    const double time = row.number("time_since_end_of_ramp_s");
    const ShearStress stress =
        row.text("protocol") == "ramp_hold"
            ? ramp_and_hold_stress(row.law(), strain, row.number("ramp_rate_1/s"), time)
            : ideal_step_stress(row.law(), strain, time);
    BOOST_TEST(stress.total() == row.number("stress_Pa"));
    BOOST_TEST(stress.total() / strain == row.number("sigma_over_gamma0_Pa"));
  }
}

// tan_delta has six decimals: half a unit is 4e-6 of it.
BOOST_AUTO_TEST_CASE(small_oscillations_are_the_prototypes) {
  const auto rows = reference_rows("saos.csv");
  BOOST_TEST(rows.size() == 30U);
  for (const ReferenceRow& row : rows) {
    const ComplexModulus moduli = small_oscillation(row.law(), row.number("omega_rad/s"));
    BOOST_TEST(moduli.storage == row.number("Gprime_Pa"),
               boost::test_tools::tolerance(of_the_files));
    BOOST_TEST(moduli.loss == row.number("Gdoubleprime_Pa"),
               boost::test_tools::tolerance(of_the_files));
    BOOST_TEST(std::abs(moduli.loss_tangent() - row.number("tan_delta")) < 0.6e-6);
  }
}

BOOST_AUTO_TEST_CASE(torques_of_discs_are_the_prototypes,
                     *boost::unit_test::tolerance(of_the_files)) {
  const auto rows = reference_rows("disc_torque.csv");
  BOOST_TEST(rows.size() == 90U);
  for (const ReferenceRow& row : rows) {
    const double radius = 1e-3 * row.number("R_mm");
    const double strain = row.number("rim_gamma"), rate = row.number("rim_rate_1/s");
    const double torque = disc_torque(row.law(), strain, rate, radius);
    BOOST_TEST(torque == row.number("torque_N_m"));
    BOOST_TEST(apparent_stress(torque, radius) == row.number("sigma_app_2M/(pi R^3)_Pa"));
    BOOST_TEST(constant_rate_stress(row.law(), strain, rate).total() ==
               row.number("sigma_rim_true_Pa"));
  }
}

// M = 2 pi int sigma r^2 dr over the radius; quadrature to 1e-12.
BOOST_AUTO_TEST_CASE(a_disc_s_torque_is_its_stress_over_all_radii,
                     *boost::unit_test::tolerance(1e-10)) {
  constexpr double R = 0.01, strain = 0.8, rate = 0.3;
  const auto ring = [&](double r) {
    return r == 0 ? 0
                  : constant_rate_stress(liver, strain * r / R, rate * r / R).total() *
                        2 * std::numbers::pi * r * r;
  };
  BOOST_TEST(disc_torque(liver, strain, rate, R) == integral(ring, 0, R));
}

// Eq. 4.1 with u = s^(1-n), which takes the singularity at s = 0 away.
BOOST_AUTO_TEST_CASE(stress_at_constant_rate_is_eq_4_1_integrated,
                     *boost::unit_test::tolerance(1e-9)) {
  const auto [K, n, limit, p] = liver;
  constexpr double strain = 0.7, rate = 0.2;
  const auto integrand = [&](double u) {
    const double s = std::pow(u, 1 / (1 - n));
    return K / std::tgamma(2 - n) * (1 + std::pow(rate * s / limit, p)) * rate;
  };
  BOOST_TEST(constant_rate_stress(liver, strain, rate).total() ==
             integral(integrand, 0, std::pow(strain / rate, 1 - n)));
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
