#include "tissue/maxwell_branches.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>

#include "tests/referee/figures.hpp"
#include "tests/tissue/refusal.hpp"

using namespace springcheck;
using namespace springcheck::tissue;

BOOST_AUTO_TEST_SUITE(maxwell_branches_test)

namespace {

const MaxwellModel model{.elastic = {400, 300},
                         .branches = {{0.1, {200, 150}}, {3, {100, 0}}},
                         .viscosity = 0.5,
                         .linear_limit = 0.4,
                         .hardening_index = 3};

}  // namespace

// The mean over the past as it is defined, with quadrature to 1e-12.
BOOST_AUTO_TEST_CASE(strains_of_branches_are_means_over_the_past,
                     *boost::unit_test::tolerance(1e-10)) {
  constexpr double strain = 0.6, rate = 0.3, ramp = strain / rate;
  for (const double tau : {0.05, 1., 40.})
    for (const double held : {0., 0.7}) {
      const double now = ramp + held;
      const auto mean_of_power = [&](double power) {
        const auto integrand = [&](double t) {
          return std::exp((t - now) / tau) / tau * std::pow(strain - rate * t, power);
        };
        return std::exp(-now / tau) * std::pow(strain, power) +
               boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
                   integrand, 0., ramp, 15, 1e-13);
      };
      const BranchStrain branch = branch_strain_after_ramp(tau, strain, rate, held);
      BOOST_TEST(branch.mean == mean_of_power(1));
      BOOST_TEST(branch.mean_square == mean_of_power(2));
    }
}

// The formula (1 - (1+x) exp(-x)) has lost its digits here: 2 (r tau)^2 x^2/2 = gamma^2.
BOOST_AUTO_TEST_CASE(a_branch_slower_than_the_ramp_has_all_its_strain,
                     *boost::unit_test::tolerance(1e-7)) {
  const BranchStrain branch = branch_strain_after_ramp(1e8, 0.01, 0.1, 0);
  BOOST_TEST(branch.mean == 0.01);
  BOOST_TEST(branch.mean_square == 1e-4);
}

// M = G + B (I/gamma_lim^2)^(p/2)/(p+1), p = 3: at I = 4 gamma_lim^2, G + 2 B.
BOOST_AUTO_TEST_CASE(stresses_are_the_branches_sum, *boost::unit_test::tolerance(1e-13)) {
  BOOST_TEST(branch_stiffness({200, 150}, 4 * 0.16, 0.4, 3) == 200 + 2 * 150);
  BOOST_TEST(branch_stiffness({200, 150}, 0, 0.4, 3) == 200);
  const BranchStrain fast = branch_strain_after_ramp(0.1, 0.8, 2, 0),
                     slow = branch_strain_after_ramp(3, 0.8, 2, 0);
  const double sum = (400 + 300 * 2) * 0.8 +
                     branch_stiffness({200, 150}, fast.mean_square, 0.4, 3) * fast.mean +
                     100 * slow.mean;
  BOOST_TEST(constant_rate_stress(model, 0.8, 2) == sum + 0.5 * 2);
  BOOST_TEST(ramp_and_hold_stress(model, 0.8, 2, 0) == sum);
  BOOST_TEST(ramp_and_hold_stress(model, 0.8, 2, 1e4) == (400 + 300 * 2) * 0.8);
}

BOOST_AUTO_TEST_CASE(moduli_are_those_of_springs_and_dashpots,
                     *boost::unit_test::tolerance(1e-13)) {
  using namespace std::complex_literals;
  for (const double omega : {0.01, 1., 30.}) {
    const std::complex<double> i_omega = omega * 1i;
    const auto G = 400. + 200. * i_omega * 0.1 / (1. + i_omega * 0.1) +
                   100. * i_omega * 3. / (1. + i_omega * 3.) + i_omega * 0.5;
    const ComplexModulus moduli = small_oscillation(model, omega);
    BOOST_TEST(moduli.storage == G.real());
    BOOST_TEST(moduli.loss == G.imag());
  }
}

// The referee's branches are tensors that it integrates in time, to 1e-11 a step.
BOOST_AUTO_TEST_CASE(stress_at_constant_rate_is_that_of_tensors_integrated_in_time,
                     *boost::unit_test::tolerance(1e-8)) {
  const MaxwellModel tried{.elastic = {400, 300},
                           .branches = {{0.1, {200, 150}}, {3, {100, 0}}, {40, {70, 90}}},
                           .viscosity = 0.5,
                           .linear_limit = 0.4,
                           .hardening_index = 3};
  const auto rows = referee::rows("branches");
  BOOST_TEST(rows.size() == 9U);
  for (const referee::Row& row : rows)
    BOOST_TEST(constant_rate_stress(tried, row.number("strain"), row.number("rate")) ==
               row.number("stress"));
}

BOOST_AUTO_TEST_CASE(models_that_cannot_be_are_refused) {
  const auto refusal_with = [](auto change) {
    MaxwellModel changed = model;
    change(changed);
    return refusal([&] { constant_rate_stress(changed, 0.1, 1); });
  };
  BOOST_TEST(refusal_with([](MaxwellModel&) {}) == "none");
  BOOST_TEST(refusal_with([](MaxwellModel& m) { m.elastic.linear = -1; }) ==
             "tissue: modulus G of a branch [Pa]: expected a finite number, 0 or above, "
             "got -1");
  BOOST_TEST(refusal_with([](MaxwellModel& m) { m.branches[1].moduli.hardening = -1; }) ==
             "tissue: modulus B of a branch [Pa]: expected a finite number, 0 or above, "
             "got -1");
  BOOST_TEST(refusal_with([](MaxwellModel& m) { m.branches[0].relaxation_time = 0; }) ==
             "tissue: relaxation time of a branch [s]: expected a finite number above 0, "
             "got 0");
  BOOST_TEST(refusal_with([](MaxwellModel& m) { m.viscosity = -1; }) != "none");
  BOOST_TEST(refusal_with([](MaxwellModel& m) { m.linear_limit = 0; }) != "none");
  BOOST_TEST(refusal_with([](MaxwellModel& m) { m.hardening_index = NAN; }) != "none");
  BOOST_TEST(refusal([] { constant_rate_stress(model, 0.1, -1); }) != "none");
  BOOST_TEST(refusal([] { ramp_and_hold_stress(model, 0.1, 1, -1); }) != "none");
  BOOST_TEST(refusal([] { small_oscillation(model, 0); }) != "none");
}

BOOST_AUTO_TEST_SUITE_END()
