#define BOOST_TEST_MODULE load_path
#include "dynamics/load_path.hpp"

#include <boost/test/unit_test.hpp>

using namespace springcheck::dynamics;

// Exact: the numbers are sums of powers of two.
BOOST_AUTO_TEST_CASE(loads_are_straight_between_their_points) {
  const LoadPath path{{.time = 2, .fraction = 1},
                      {.time = 4, .fraction = 1},
                      {.time = 8, .fraction = -0.5}};
  BOOST_TEST(load_fraction(path, 0) == 0);
  BOOST_TEST(load_fraction(path, 0.5) == 0.25);
  BOOST_TEST(load_fraction(path, 2) == 1);
  BOOST_TEST(load_fraction(path, 3) == 1);
  BOOST_TEST(load_fraction(path, 6) == 0.25);
  BOOST_TEST(load_fraction(path, 8) == -0.5);
  BOOST_TEST(pieces_passed(path, 0.5) == 0.25);
  BOOST_TEST(pieces_passed(path, 2) == 1);
  BOOST_TEST(pieces_passed(path, 6) == 2.5);
  BOOST_TEST(pieces_passed(path, 8) == 3);
}

// To the bit, as loads grew before they had paths.
BOOST_AUTO_TEST_CASE(a_ramp_is_in_proportion_to_the_time) {
  const LoadPath path = ramp(0.3);
  for (const double time : {0., 0.1, 0.2, 0.3}) {
    BOOST_TEST(load_fraction(path, time) == time / 0.3);
    BOOST_TEST(pieces_passed(path, time) == time / 0.3);
  }
}
