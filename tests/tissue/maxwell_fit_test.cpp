#include "tissue/maxwell_fit.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "tests/tissue/refusal.hpp"

using namespace springcheck;
using namespace springcheck::tissue;

BOOST_AUTO_TEST_SUITE(maxwell_fit_test)

namespace {

/// The bands that the model is to hold.
bool is_within_bands(const FitErrors& errors) {
  return errors.constant_rate_rms < 0.004 && errors.constant_rate < 0.02 &&
         errors.ramp_and_hold < 0.03 && errors.storage < 0.02 && errors.loss < 0.05;
}

std::string text_of(const FitErrors& errors) {
  std::ostringstream text;
  text << errors.constant_rate_rms << ", " << errors.constant_rate << ", "
       << errors.ramp_and_hold << ", " << errors.storage << ", " << errors.loss;
  return text.str();
}

}  // namespace

// The least number of branches that does: five miss the band of G'' in liver and kidney.
BOOST_AUTO_TEST_CASE(six_branches_hold_all_bands_and_five_do_not) {
  for (const Organ& organ : organs()) {
    const MaxwellFit six = fit_maxwell_model(organ.law);
    BOOST_TEST(six.model.branches.size() == 6U);
    BOOST_TEST(is_within_bands(six.errors), organ.name << ": " << text_of(six.errors));
  }
  for (const char* organ : {"liver", "kidney"})
    BOOST_TEST(fit_maxwell_model(law_of_organ(organ), {}, 5).errors.loss > 0.05);
}

// Two and three branches are too few for the range itself.
BOOST_AUTO_TEST_CASE(any_number_of_branches_stays_near_the_law_at_faster_rates) {
  for (const Organ& organ : organs())
    for (const int branches : {2, 3, 4, 5, 7, 8, 13, 32}) {
      const FitErrors errors = fit_maxwell_model(organ.law, {}, branches).errors;
      BOOST_TEST(errors.guess <= largest_error_of_guess,
                 organ.name << ", " << branches << ": " << errors.guess);
      if (branches > 3)
        BOOST_TEST(errors.constant_rate < 0.02, organ.name << ", " << branches);
    }
}

// The rates are such as no sample has, to 50 1/s and far beyond.
BOOST_AUTO_TEST_CASE(stress_rises_with_the_rate_and_near_the_law) {
  for (const Organ& organ : organs())
    for (const int branches : {3, 6, 12}) {
      const MaxwellModel model = fit_maxwell_model(organ.law, {}, branches).model;
      for (const double strain : {0.013, 0.17, 0.95}) {
        double before = 0;
        for (double rate = 1e-4; rate < 1e4; rate *= 1.13) {
          const double stress = constant_rate_stress(model, strain, rate);
          BOOST_TEST(stress > before);
          before = stress;
          if (rate < 0.67 || rate > 50) continue;
          const double law = constant_rate_stress(organ.law, strain, rate).total();
          BOOST_TEST(stress > 0.8 * law);
          BOOST_TEST(stress < 1.2 * law);
        }
      }
    }
}

// Where nothing is asked of faster rates, nothing is given for them.
BOOST_AUTO_TEST_CASE(a_range_alone_does_not_tell_of_faster_rates) {
  const BipowerLaw liver = law_of_organ("liver");
  const MaxwellModel alone = fit_maxwell_model(liver, {.fastest_guess = 0.67}).model;
  BOOST_TEST(errors_of(alone, liver, {}).guess > 1);
}

// A model that is 10 % too stiff in all it has is off by that everywhere, as far as the
// model itself follows the law (.4 %, of G'' 5 %).
BOOST_AUTO_TEST_CASE(errors_are_the_model_s_deviations) {
  const BipowerLaw law = law_of_organ("spleen");
  MaxwellModel stiff = fit_maxwell_model(law).model;
  const auto stiffen = [](BranchModuli& moduli) {
    moduli.linear *= 1.1;
    moduli.hardening *= 1.1;
  };
  stiffen(stiff.elastic);
  for (MaxwellBranch& branch : stiff.branches) stiffen(branch.moduli);
  stiff.viscosity *= 1.1;
  const FitErrors errors = errors_of(stiff, law, {});
  BOOST_TEST(std::abs(errors.constant_rate_rms - std::log(1.1)) < 0.004);
  BOOST_TEST(std::abs(errors.constant_rate - 0.1) < 0.01);
  BOOST_TEST(std::abs(errors.ramp_and_hold - 0.1) < 0.03);
  BOOST_TEST(std::abs(errors.storage - 0.1) < 0.02);
  BOOST_TEST(std::abs(errors.loss - 0.1) < 0.055);
}

// The range covers eight decades of time, with about one branch to each.
BOOST_AUTO_TEST_CASE(more_branches_hold_over_a_wider_range) {
  const FitRange wide{.strains = {0.01, 0.3},
                      .rates = {1e-3, 10},
                      .times_held = {1e-4, 1e4},
                      .angular_frequencies = {1e-3, 1e3}};
  const BipowerLaw liver = law_of_organ("liver");
  const MaxwellFit nine = fit_maxwell_model(liver, wide, 9);
  BOOST_TEST(is_within_bands(nine.errors), text_of(nine.errors));
  BOOST_TEST(!is_within_bands(fit_maxwell_model(liver, wide, 5).errors));
  BOOST_TEST(!is_within_bands(errors_of(fit_maxwell_model(liver).model, liver, wide)));
  BOOST_TEST(nine.range.rates.contains(5));
  BOOST_TEST(!nine.range.rates.contains(11));
  BOOST_TEST(!nine.range.strains.contains(0.5));
}

BOOST_AUTO_TEST_CASE(a_fit_can_be_used_and_is_always_the_same) {
  for (const Organ& organ : organs()) {
    const MaxwellFit fit = fit_maxwell_model(organ.law),
                     again = fit_maxwell_model(organ.law);
    BOOST_CHECK_NO_THROW(check(fit.model));
    BOOST_TEST(fit.model.linear_limit == organ.law.linear_limit);
    BOOST_TEST(fit.model.hardening_index == organ.law.hardening_index);
    BOOST_TEST(fit.model.viscosity == again.model.viscosity);
    for (std::size_t i = 0; i < fit.model.branches.size(); ++i) {
      const MaxwellBranch &one = fit.model.branches[i], &other = again.model.branches[i];
      BOOST_TEST(one.relaxation_time == other.relaxation_time);
      BOOST_TEST(one.moduli.linear == other.moduli.linear);
      BOOST_TEST(one.moduli.hardening == other.moduli.hardening);
    }
  }
}

// Stresses go with K, times with nothing: round-off of a least-squares problem.
BOOST_AUTO_TEST_CASE(moduli_go_with_the_consistency, *boost::unit_test::tolerance(1e-6)) {
  BipowerLaw law = law_of_organ("spleen");
  const MaxwellFit fit = fit_maxwell_model(law);
  law.consistency *= 10;
  const MaxwellFit ten = fit_maxwell_model(law);
  BOOST_TEST(ten.model.elastic.linear == 10 * fit.model.elastic.linear);
  BOOST_TEST(ten.model.viscosity == 10 * fit.model.viscosity);
  BOOST_TEST(ten.errors.loss == fit.errors.loss);
  law.consistency *= 1e160;  // so large that squares of stresses overflow
  const MaxwellFit huge = fit_maxwell_model(law);
  BOOST_TEST(huge.model.viscosity == 1e161 * fit.model.viscosity);
  BOOST_TEST(huge.errors.loss == fit.errors.loss);
}

// A single strain, rate, time and frequency can be had from two branches.
BOOST_AUTO_TEST_CASE(ranges_may_be_points) {
  const FitRange point{.strains = {0.1, 0.1},
                       .rates = {0.1, 0.1},
                       .times_held = {1, 1},
                       .angular_frequencies = {1, 1},
                       .fastest_guess = 0.1};
  const MaxwellFit fit = fit_maxwell_model(law_of_organ("kidney"), point, 2);
  BOOST_TEST(fit.errors.constant_rate < 1e-6);
  BOOST_TEST(fit.errors.loss < 1e-6);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_fitted_is_refused) {
  const BipowerLaw law = law_of_organ("liver");
  BOOST_TEST(refusal([&] { fit_maxwell_model(law, {}, 1); }) ==
             "tissue: number of Maxwell branches: expected 2 to 32, got 1");
  BOOST_TEST(refusal([&] { fit_maxwell_model(law, {}, 33); }) ==
             "tissue: number of Maxwell branches: expected 2 to 32, got 33");
  BOOST_TEST(refusal([&] {
               fit_maxwell_model({1, 2, 3, 4});
             }) ==
             "tissue: linear index n: expected a number above 0 and below 1, got 2");
  BOOST_TEST(refusal([&] {
               fit_maxwell_model(law, {.strains = {0.5, 0.1}});
             }).starts_with("tissue: range of strains: expected a lower end below"));
  BOOST_TEST(refusal([&] {
               fit_maxwell_model(law, {.rates = {0, 0.1}});
             }) ==
             "tissue: lower end of strain rates [1/s]: expected a finite number "
             "above 0, got 0");
  BOOST_TEST(refusal([&] {
               fit_maxwell_model(law, {.times_held = {1, INFINITY}});
             }) != "none");
  BOOST_TEST(refusal([&] {
               fit_maxwell_model(law, {.angular_frequencies = {-1, 1}});
             }) != "none");
  BOOST_TEST(refusal([&] { fit_maxwell_model(law, {.fastest_guess = 0}); }) ==
             "tissue: fastest guess [1/s]: expected a finite number above 0, got 0");
}

BOOST_AUTO_TEST_SUITE_END()
