#include "tissue/strain_history.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "meshing/basics/input_error.hpp"

using namespace springcheck;
using namespace springcheck::tissue;

BOOST_AUTO_TEST_SUITE(strain_history_test)

namespace {

const BipowerLaw liver = law_of_organ("liver"), spleen = law_of_organ("spleen");

// So stiff a limit that nothing hardens.
constexpr BipowerLaw linear{
    .consistency = 800, .linear_index = 0.1, .linear_limit = 1e9, .hardening_index = 2};

/// Eq. 4.1 as it stands, piece by piece, over u = s^(1-n).
double stress_as_it_stands(const BipowerLaw& law, const StrainHistory& history,
                           double time) {
  const auto [K, n, limit, p] = law;
  const double now = strain_at(history, time);
  double sum = 0;
  for (std::size_t i = 0; i < history.times.size() && history.times[i] < time; ++i) {
    const bool is_last = i + 1 == history.times.size();
    const double end = is_last ? time : std::min(time, history.times[i + 1]);
    const double rate = is_last ? 0
                                : (history.strains[i + 1] - history.strains[i]) /
                                      (history.times[i + 1] - history.times[i]);
    if (rate == 0) continue;
    const auto integrand = [&](double u) {
      const double s = std::pow(u, 1 / (1 - n));
      const double D = now - strain_at(history, time - s);
      return K / std::tgamma(2 - n) * (1 + std::pow(std::abs(D / limit), p)) * rate;
    };
    sum += boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
        integrand, std::pow(time - end, 1 - n), std::pow(time - history.times[i], 1 - n),
        20, 1e-12);
  }
  return sum;
}

}  // namespace

// The stress is computed by parts here, by closed forms there; quadrature is to 1e-10.
BOOST_AUTO_TEST_CASE(ramps_and_holds_are_the_closed_forms,
                     *boost::unit_test::tolerance(1e-9)) {
  for (const Organ& organ : organs())
    for (const double strain : {0.01, 0.3, 1.}) {
      constexpr double rate = 0.133;
      const double end = strain / rate;
      const StrainHistory history{{0, end}, {0, strain}};
      BOOST_TEST(stress(organ.law, history, end / 3) ==
                 constant_rate_stress(organ.law, strain / 3, rate).total());
      BOOST_TEST(stress(organ.law, history, end) ==
                 constant_rate_stress(organ.law, strain, rate).total());
      for (const double held : {1e-6, 1e-3, 1., 1e3})
        BOOST_TEST(stress(organ.law, history, end + held) ==
                   ramp_and_hold_stress(organ.law, strain, rate, held).total());
    }
}

// Cutting a ramp into pieces changes nothing: the newest is in closed form, the others by
// quadrature.
BOOST_AUTO_TEST_CASE(pieces_of_a_ramp_are_the_ramp, *boost::unit_test::tolerance(1e-9)) {
  const StrainHistory history{{1, 1.5, 3, 3.01}, {0, 0.25, 1, 1.005}};
  for (const double time : {1.2, 1.5, 1.50001, 2., 3., 3.005, 3.01})
    BOOST_TEST(stress(liver, history, time) ==
               constant_rate_stress(liver, 0.5 * (time - 1), 0.5).total());
}

BOOST_AUTO_TEST_CASE(a_jump_is_the_ideal_step, *boost::unit_test::tolerance(1e-12)) {
  const StrainHistory jump{{2}, {0.6}};
  for (const double time : {1e-3, 1., 70.})
    BOOST_TEST(stress(spleen, jump, 2 + time) ==
               ideal_step_stress(spleen, 0.6, time).total());
}

// The stress is K r/Gamma(2-n) {t^(1-n) - 2 (t-T)^(1-n)}, by superposition of ramps.
BOOST_AUTO_TEST_CASE(linear_stresses_of_ramps_add_up,
                     *boost::unit_test::tolerance(1e-9)) {
  const auto [K, n, limit, p] = linear;
  constexpr double rate = 0.2, T = 5;
  const StrainHistory history{{0, T, 2 * T}, {0, rate * T, 0}};
  for (const double t : {6., 8., 9.9})
    BOOST_TEST(stress(linear, history, t) ==
               K * rate / std::tgamma(2 - n) *
                   (std::pow(t, 1 - n) - 2 * std::pow(t - T, 1 - n)));
}

// Unloading, another sign, holds: |D|^p and the by-parts form against Eq. 4.1 as it is.
BOOST_AUTO_TEST_CASE(any_history_is_eq_4_1_with_the_modulus_of_its_strain,
                     *boost::unit_test::tolerance(1e-8)) {
  const StrainHistory history{{0, 1, 1.5, 4, 5, 8}, {0, 0.8, 0.8, -0.5, 0, 1}};
  for (const Organ& organ : organs())
    for (const double time : {0.5, 1., 1.2, 1.6, 3., 4.5, 5.1, 7.9, 8., 12.}) {
      const double expected = stress_as_it_stands(organ.law, history, time);
      BOOST_TEST(stress(organ.law, history, time) == expected,
                 organ.name << " at " << time);
    }
}

BOOST_AUTO_TEST_CASE(the_other_way_round_gives_the_other_sign,
                     *boost::unit_test::tolerance(1e-12)) {
  const StrainHistory one{{0, 1, 2, 5}, {0, 0.8, 0.1, 1}};
  const StrainHistory other{{0, 1, 2, 5}, {0, -0.8, -0.1, -1}};
  for (const double time : {0.9, 1.7, 4., 6.})
    BOOST_TEST(stress(liver, one, time) == -stress(liver, other, time));
}

// gamma_0 sin(omega t) from a start, three periods on, in 80 chords a period: the start
// is felt as gamma_0 K t^(-1-n) n/Gamma(1-n)/omega, below 1 %, chords as (pi/80)^2/3 =
// .05 %.
BOOST_AUTO_TEST_CASE(an_oscillation_has_the_storage_and_loss_modulus) {
  constexpr double omega = 2, strain = 1e-4;
  constexpr int chords = 80, periods = 3;
  const double dt = 2 * std::numbers::pi / omega / chords;
  StrainHistory history;
  for (int i = 0; i <= periods * chords; ++i) {
    history.times.push_back(i * dt);
    history.strains.push_back(strain * std::sin(omega * i * dt));
  }
  double storage = 0, loss = 0;
  for (int i = (periods - 1) * chords; i < periods * chords; ++i) {
    const double t = i * dt, sigma = stress(spleen, history, t);
    storage += 2 * sigma * std::sin(omega * t) / (strain * chords);
    loss += 2 * sigma * std::cos(omega * t) / (strain * chords);
  }
  const ComplexModulus expected = small_oscillation(spleen, omega);
  BOOST_TEST(storage == expected.storage, boost::test_tools::tolerance(0.005));
  BOOST_TEST(loss == expected.loss, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(strains_are_straight_between_times) {
  const StrainHistory history{{1, 2, 4}, {0.5, 1, 0}};
  BOOST_TEST(strain_at(history, 0.9) == 0);
  BOOST_TEST(strain_at(history, 1) == 0.5);
  BOOST_TEST(strain_at(history, 3) == 0.5);
  BOOST_TEST(strain_at(history, 9) == 0);
  BOOST_TEST(stress(liver, history, 0.9) == 0);
  BOOST_TEST(stress(liver, {{0, 1}, {0, 1}}, 0) == 0);
  BOOST_TEST(stress(liver, {{0, 1}, {0, 0}}, 2) == 0);
}

BOOST_AUTO_TEST_CASE(what_is_no_history_is_refused) {
  const auto refuses = [](const StrainHistory& history) {
    BOOST_CHECK_THROW(stress(liver, history, 1), InputError);
  };
  refuses({{}, {}});
  refuses({{0, 1}, {0}});
  refuses({{0, 1, 1}, {0, 1, 2}});
  refuses({{0, 2, 1}, {0, 1, 2}});
  refuses({{0, NAN}, {0, 1}});
  refuses({{0, 1}, {0, INFINITY}});
  refuses({{1}, {0.5}});  // the stress of a jump at its own time is infinite
}

// The stress is compared with the closed forms for ramps, and through a cycle with steps
// so small that the mean over the past is summed as MaxwellModel defines it: by the
// midpoint rule, which is of second order.
BOOST_AUTO_TEST_CASE(branches_remember_any_history) {
  const MaxwellModel model{.elastic = {300, 200},
                           .branches = {{.02, {500, 900}}, {3, {400, 100}}},
                           .viscosity = 5,
                           .linear_limit = .4,
                           .hardening_index = 1.7};
  const StrainHistory ramp{{0, 2}, {0, .6}};
  for (const double time : {.3, 1.9})
    BOOST_TEST(stress(model, ramp, time) == constant_rate_stress(model, .3 * time, .3),
               boost::test_tools::tolerance(1e-12));
  BOOST_TEST(stress(model, ramp, 2.7) == ramp_and_hold_stress(model, .6, .3, .7),
             boost::test_tools::tolerance(1e-12));

  const StrainHistory cycle{{0, .5, 1.5, 2}, {.1, .5, -.5, 0}};
  constexpr double time = 1.8;
  constexpr int parts = 200000;
  double sum = model.viscosity;  // at the rate 1
  const auto add = [&](const BranchModuli& moduli, double mean, double mean_square) {
    sum += mean * branch_stiffness(moduli, mean_square, .4, 1.7);
  };
  const double now = strain_at(cycle, time);
  add(model.elastic, now, now * now);
  for (const auto& [tau, moduli] : model.branches) {
    double mean = std::exp(-time / tau) * now, square = std::exp(-time / tau) * now * now;
    for (int i = 0; i < parts; ++i) {
      const double ago = time * (i + .5) / parts;
      const double D = now - strain_at(cycle, time - ago);
      const double weight = std::exp(-ago / tau) / tau * time / parts;
      mean += D * weight;
      square += D * D * weight;
    }
    add(moduli, mean, square);
  }
  BOOST_TEST(stress(model, cycle, time) == sum, boost::test_tools::tolerance(1e-7));
}

BOOST_AUTO_TEST_SUITE_END()
