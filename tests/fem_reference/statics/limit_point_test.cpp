#include "fem_reference/statics/limit_point.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <vector>

using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(limit_point_test)

namespace {

/// The rates at states whose distance to the failure at .5 is halved again and again, as
/// load steps are.
std::vector<Rate> rates_of(const std::function<double(double)>& rate) {
  std::vector<Rate> rates;
  for (double distance = 1. / 4; distance > 1. / 1500; distance /= 2)
    rates.push_back(
        {.load_fraction = 0.5 - distance, .displacement = rate(0.5 - distance)});
  return rates;
}

/// With a limit point at s_c that moves as much as `part` of the regular rate at a
/// distance of 1.
std::function<double(double)> folding(double part, double limit) {
  return [=](double s) { return 1 + s + part / std::sqrt(limit - s); };
}

}  // namespace

// The limit point lies between the last state, at .5 - 1/1024, and the failure.
BOOST_AUTO_TEST_CASE(rates_that_rise_as_before_a_limit_point_tell_it) {
  for (const double part : {0.01, 0.1, 1., 10.})
    for (const double limit : {0.5, 0.4997, 0.4992})
      BOOST_TEST(limit_point_ahead(rates_of(folding(part, limit)), 0.5),
                 part << ", " << limit);
}

// Steady, rising or falling rates, also steeply; the way down from the pole of a
// bifurcation at .4; one that is far ahead; a change too small to tell.
BOOST_AUTO_TEST_CASE(other_rates_do_not) {
  const std::function<double(double)> others[] = {
      [](double) { return 1.; },
      [](double s) { return 1 + 100 * s; },
      [](double s) { return 100 - 100 * s; },
      [](double s) { return std::exp(5 * s); },
      [](double s) { return 1 / std::abs(s - 0.4); },
      folding(1, 0.6),
      folding(1e-5, 0.5),
  };
  for (const auto& rate : others) BOOST_TEST(!limit_point_ahead(rates_of(rate), 0.5));
}

// Three states at different distances are the least.
BOOST_AUTO_TEST_CASE(too_few_states_do_not) {
  const std::vector<Rate> rates = rates_of(folding(1, 0.5));
  BOOST_TEST(!limit_point_ahead({}, 0.5));
  BOOST_TEST(!limit_point_ahead(std::span(rates).last(1), 0.5));
  BOOST_TEST(!limit_point_ahead(std::span(rates).last(2), 0.5));
  BOOST_TEST(limit_point_ahead(std::span(rates).last(3), 0.5));
}

BOOST_AUTO_TEST_SUITE_END()
