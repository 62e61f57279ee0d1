#include "comparisons/methods/families.hpp"

#include <boost/test/unit_test.hpp>

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(tissue_test)

namespace {

Dynamics dynamics_of(const dynamics::LoadPath& load) {
  Dynamics dynamics{};
  dynamics.duration = load.back().time;
  dynamics.load = load;
  return dynamics;
}

Dynamics oscillating(double angular_frequency) {
  Dynamics swings = dynamics_of(dynamics::oscillation(angular_frequency, 2));
  swings.oscillation = Oscillation{.angular_frequency = angular_frequency, .cycles = 2};
  return swings;
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_leaves_the_fitted_range_is_called_an_extrapolation) {
  const tissue::FitRange range;
  const auto beyond = [&](const dynamics::LoadPath& load, double strain) {
    return extrapolation(range, dynamics_of(load), strain);
  };
  const dynamics::LoadPath within{{.time = 1 / 0.133, .fraction = 1}};
  BOOST_TEST(beyond(within, 1).empty());
  Dynamics ramp{};
  ramp.duration = 1 / 0.133;
  BOOST_TEST(extrapolation(range, ramp, 1).empty());
  BOOST_TEST(beyond(within, 1.5) ==
             "extrapolated beyond the fitted range: shear strains of 1.5 (fitted to 1)");
  const std::string fast = beyond({{.time = 0.5, .fraction = 1}}, 0.5);
  BOOST_TEST(fast.ends_with("rates of 1 1/s (fitted from 0.0151 to 0.67)"), fast);
  BOOST_TEST(!beyond({{.time = 1000, .fraction = 1}}, 0.5).empty());
  // Small strains are linear; their range is that of the frequencies.
  BOOST_TEST(beyond({{.time = 0.01, .fraction = 1}}, 0.005).empty());
  BOOST_TEST(beyond({{.time = 100, .fraction = 1}}, 0.005).empty());
  BOOST_TEST(
      beyond({{.time = 1e-4, .fraction = 1}}, 0.005) ==
      "extrapolated beyond the fitted range: a small strain within 0.0001 s (fitted "
      "from 0.01 s)");
  // A hold has no rate.
  BOOST_TEST(
      beyond({{.time = 1, .fraction = 1}, {.time = 101, .fraction = 1}}, 0.5).empty());
  BOOST_TEST(beyond({{.time = 1, .fraction = 1}, {.time = 1e3, .fraction = 1}}, 0.5) ==
             "extrapolated beyond the fitted range: a hold of 999 s (fitted to 100 s)");
}

// A mean of 2/pi omega times the strain: .16 1/s of .5 at .5 rad/s.
BOOST_AUTO_TEST_CASE(oscillations_have_a_mean_rate_or_a_frequency) {
  const tissue::FitRange range;
  BOOST_TEST(extrapolation(range, oscillating(0.5), 0.5).empty());
  BOOST_TEST(!extrapolation(range, oscillating(10), 0.5).empty());
  BOOST_TEST(extrapolation(range, oscillating(10), 0.001).empty());
  BOOST_TEST(
      extrapolation(range, oscillating(1e4), 0.001) ==
      "extrapolated beyond the fitted range: 10000 rad/s (fitted from 0.1 to 100)");
}

BOOST_AUTO_TEST_SUITE_END()
