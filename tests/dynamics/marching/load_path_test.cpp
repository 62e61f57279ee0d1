#include "dynamics/marching/load_path.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

using namespace springcheck::dynamics;

BOOST_AUTO_TEST_SUITE(load_path_test)

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

// The ramp is, bit for bit, what loads were before they had paths.
BOOST_AUTO_TEST_CASE(a_ramp_is_in_proportion_to_the_time) {
  const LoadPath path = ramp(0.3);
  for (const double time : {0., 0.1, 0.2, 0.3}) {
    BOOST_TEST(load_fraction(path, time) == time / 0.3);
    BOOST_TEST(pieces_passed(path, time) == time / 0.3);
  }
}

// Whoever divides by the load must see that there is none.
BOOST_AUTO_TEST_CASE(an_oscillation_of_half_cycles_ends_without_a_load) {
  for (const double cycles : {0.5, 1., 2.5, 5.})
    BOOST_TEST(oscillation(3, cycles).back().fraction == 0);
  BOOST_TEST(oscillation(3, 5.1).back().fraction != 0);
}

// Chords of an arc lie off it by an eighth of the square of their length in angle.
BOOST_AUTO_TEST_CASE(an_oscillation_is_a_sine_but_for_its_chords) {
  constexpr double frequency = 3, two_pi = 2 * std::numbers::pi;
  const LoadPath path = oscillation(frequency, 2.25);
  BOOST_TEST(path.size() == 144U);
  BOOST_TEST(path.back().time == 2.25 * two_pi / frequency,
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(path.back().fraction == 1, boost::test_tools::tolerance(1e-14));
  const double sagitta = std::pow(two_pi / 64, 2) / 8;
  for (double time = 0; time < path.back().time; time += 0.0123)
    BOOST_TEST(std::abs(load_fraction(path, time) - std::sin(frequency * time)) <
               1.01 * sagitta);
}

BOOST_AUTO_TEST_CASE(a_part_of_a_cycle_ends_where_it_was_to_end) {
  const LoadPath path = oscillation(1, 0.1);
  BOOST_TEST(path.size() == 7U);  // 6.4 pieces of a cycle/64
  BOOST_TEST(oscillation(1, 1e-13).size() == 1U);
  BOOST_TEST(path.back().time == 0.2 * std::numbers::pi,
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_path_turns_where_it_rises_falls_or_rests) {
  const LoadPath turns = turning_points({{.time = 1, .fraction = 0.2},
                                         {.time = 2, .fraction = 1},
                                         {.time = 3, .fraction = 1},
                                         {.time = 4, .fraction = 1},
                                         {.time = 5, .fraction = 0.5},
                                         {.time = 6, .fraction = -1}});
  BOOST_TEST_REQUIRE(turns.size() == 3U);
  BOOST_TEST(turns[0].time == 2);
  BOOST_TEST(turns[1].time == 4);
  BOOST_TEST(turns[2].time == 6);
  BOOST_TEST(turning_points(oscillation(3, 2.25)).size() == 5U);
  BOOST_TEST(turning_points(ramp(3)).size() == 1U);
}

BOOST_AUTO_TEST_SUITE_END()
