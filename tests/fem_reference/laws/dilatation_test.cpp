#include "fem_reference/laws/dilatation.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(dilatation_test)

// Slopes by central differences of 1e-6, whose error here is below 1e-8 of them.
BOOST_AUTO_TEST_CASE(slopes_are_those_of_the_energy, *boost::unit_test::tolerance(1e-7)) {
  constexpr double h = 1e-6;
  for (const auto& energy : {quadratic, logarithmic, cubic_logarithmic})
    for (const double t : {-0.8, -0.6, -0.3, 0.2, 1.}) {
      const VolumetricEnergy below = energy(3, t - h), at = energy(3, t),
                             above = energy(3, t + h);
      BOOST_TEST(at.first == (above.value - below.value) / (2 * h));
      BOOST_TEST(at.second == (above.first - below.first) / (2 * h));
    }
}

// ln^3 J/3 to J = 1/2, and what goes on there with its slope and curvature.
BOOST_AUTO_TEST_CASE(the_cubic_term_never_falls_without_bound) {
  const double q = std::log(0.7);
  BOOST_TEST(cubic_logarithmic(1, -0.3).value == q * q * q / 3,
             boost::test_tools::tolerance(1e-14));
  const VolumetricEnergy above = cubic_logarithmic(1, -0.5 + 1e-9),
                         below = cubic_logarithmic(1, -0.5 - 1e-9);
  BOOST_TEST(std::abs(above.value - below.value) < 1e-8);
  BOOST_TEST(std::abs(above.first - below.first) < 1e-7);
  BOOST_TEST(std::abs(above.second - below.second) < 1e-6);
  BOOST_TEST(cubic_logarithmic(1, -1 + 1e-6).value > 100);
}

BOOST_AUTO_TEST_SUITE_END()
