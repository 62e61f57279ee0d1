#define SPRINGCHECK_PATH portable
#include "dynamics/blocks/pack_powers.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

using namespace springcheck::dynamics::SPRINGCHECK_PATH;

BOOST_AUTO_TEST_SUITE(pack_powers_test)

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Numbers about sqrt(1/2), where the exponent changes, about 1, and everywhere else.
std::vector<double> numbers() {
  std::vector<double> all{std::sqrt(0.5),
                          std::nextafter(std::sqrt(0.5), 0),
                          std::nextafter(std::sqrt(0.5), 1),
                          std::sqrt(2.),
                          1,
                          1 + epsilon,
                          1 - epsilon / 2,
                          1e-300,
                          1e300,
                          std::numeric_limits<double>::min()};
  for (double x = 1e-12; x < 1e12; x *= 1.37) all.push_back(x);
  return all;
}

}  // namespace

// The series is cut at .1716^16/17 of its first term, 3.3e-14.
BOOST_AUTO_TEST_CASE(logarithms_are_those_of_the_library) {
  for (const double x : numbers()) {
    const double expected = std::log2(x);
    BOOST_TEST(
        std::abs(log2(all(x))[0] - expected) <=
            4e-14 * std::min(std::abs(expected), 0.5) + 3 * epsilon * std::abs(expected),
        x);
  }
}

BOOST_AUTO_TEST_CASE(exponentials_are_those_of_the_library) {
  for (double y = -999.3; y < 1000; y += 0.731)
    BOOST_TEST(exp2(all(y))[0] == std::exp2(y),
               boost::test_tools::tolerance(8.9e-15 + 2 * epsilon));
  BOOST_TEST(exp2(all(0.))[0] == 1);
  BOOST_TEST(exp2(all(10.))[0] == 1024);
  BOOST_TEST(exp2(all(2000.))[0] == std::exp2(1000));
  BOOST_TEST(exp2(all(-2000.))[0] == std::exp2(-1000));
}

BOOST_AUTO_TEST_CASE(powers_keep_their_digits_and_those_of_nothing_are_nothing) {
  for (const double q : {2. / 3, 0.6, 2.085, 3.})
    for (const double x : numbers()) {
      const double expected = std::pow(x, q), log = std::abs(std::log2(expected));
      if (log > 990) continue;
      BOOST_TEST(std::abs(power(all(x), q)[0] - expected) <=
                     (1e-14 + 2e-14 * q + 2 * epsilon * log) * expected,
                 x << '^' << q);
    }
  BOOST_TEST(power(all(0.), 2)[0] < 1e-300);
  BOOST_TEST(power(all(0.), 0.6)[0] < 1e-180);
}

BOOST_AUTO_TEST_SUITE_END()
