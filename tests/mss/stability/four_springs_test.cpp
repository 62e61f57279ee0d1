#include "mss/stability/four_springs.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "mss/forces/forces.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(four_springs_test)

namespace {

constexpr FourSprings system_of_test{.stiffness = 3, .length = 0.2};
constexpr double k = system_of_test.stiffness, l = system_of_test.length;

}  // namespace

// Eq. 3.13, 3.14 and the force before x is put in of 3.18; round-off.
BOOST_AUTO_TEST_CASE(the_network_has_the_thesis_s_energy_and_forces,
                     *boost::unit_test::tolerance(1e-13)) {
  const Network network = network_of(system_of_test);
  for (const double zeta : {-1.2, -0.3, 0.2, 0.7, 1.5})
    for (const double x : {-0.15, 0.01, 0.1}) {
      const double now = std::hypot(zeta * l, x);
      const std::vector<Vector3> places{
          {0, zeta * l, 0}, {0, -zeta * l, 0}, {x, 0, 0}, {-l, 0, 0}, {l, 0, 0}};
      BOOST_TEST(strain_energy(network, places) == k * ((now - l) * (now - l) + x * x));
      const auto [centre, top] = forces_at(system_of_test, x, zeta);
      BOOST_TEST(centre == 2 * k * x * (l / now - 2));
      BOOST_TEST(top == k * zeta * l * (l / now - 1));
    }
}

// 2 k (2 - 1/|zeta|); round-off.
BOOST_AUTO_TEST_CASE(it_bifurcates_at_plus_and_minus_one_half) {
  for (const double zeta : {-2., -0.7, -0.3, 0.2, 0.6, 1.})
    BOOST_TEST(
        stiffness_of_centre(system_of_test, zeta) == 2 * k * (2 - 1 / std::abs(zeta)),
        boost::test_tools::tolerance(1e-13));
  BOOST_TEST(std::abs(bifurcation(system_of_test) - 0.5) < 1e-14);
  for (const double side : {-1., 1.}) {
    BOOST_TEST(stiffness_of_centre(system_of_test, side * (0.5 + 1e-12)) > 0);
    BOOST_TEST(stiffness_of_centre(system_of_test, side * (0.5 - 1e-12)) < 0);
    BOOST_TEST(centre_at_rest(system_of_test, side * (0.5 + 1e-10)) == 0);
    // sqrt(1/4 - zeta^2) is 1e-4 here, and forces have few digits left.
    BOOST_TEST(centre_at_rest(system_of_test, side * (0.5 - 1e-8)) == 1e-4 * l,
               boost::test_tools::tolerance(1e-3));
  }
}

// Eq. 3.15 and 3.18. Bisected to 1e-14 l.
BOOST_AUTO_TEST_CASE(c_rests_where_the_thesis_says_and_a_feels_the_kinked_force) {
  for (const double zeta : {-0.49, -0.2, 0., 0.3, 0.499}) {
    const double x = centre_at_rest(system_of_test, zeta);
    BOOST_TEST(std::abs(x - l * std::sqrt(0.25 - zeta * zeta)) < 1e-12 * l);
    BOOST_TEST(std::abs(forces_at(system_of_test, x, zeta).top - k * l * zeta) <
               1e-12 * k * l);
  }
  for (const double zeta : {-1.4, -0.6, 0.51, 1., 2.})
    BOOST_TEST(
        std::abs(
            forces_at(system_of_test, centre_at_rest(system_of_test, zeta), zeta).top -
            k * l * (std::copysign(1, zeta) - zeta)) < 1e-14);
}

// Straight on both sides, zeta = 1 - F/kl or -1 - F/kl; over from one to the other only
// beyond F = k l/2 and back only beyond -k l/2. Bisected to 1e-13.
BOOST_AUTO_TEST_CASE(the_loop_is_that_of_figure_3_2) {
  constexpr int steps = 8;
  constexpr double load_step = 0.12 * k * l;  // .48 and .60 around the jump
  const auto loop = hysteresis_loop(system_of_test, load_step, steps);
  BOOST_TEST_REQUIRE(loop.size() == 1U + 5 * steps);
  double side = 1;
  for (const FourSpringRest& rest : loop) {
    const double F = rest.load / (k * l);
    if (F > 0.5) side = -1;
    if (F < -0.5) side = 1;
    BOOST_TEST(std::abs(rest.zeta - (side - F)) < 1e-12, "F/kl = " << F);
    BOOST_TEST(rest.x == 0);
  }
  BOOST_TEST(loop[steps].load == 0.96 * k * l, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(loop[2 * steps].zeta == -1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(loop.back().load == loop[steps].load);
}

// A hair beyond each critical load: from 1/2 to -3/2, and from -1/2 to 3/2, where the
// thesis's text has 1/2.
BOOST_AUTO_TEST_CASE(jumps_end_one_and_a_half_lengths_away) {
  const double critical = k * l / 2;
  const auto rest = [](double load, double from) {
    return rest_under(system_of_test, load, from).zeta;
  };
  BOOST_TEST(std::abs(rest(critical * (1 - 1e-9), 0.6) - 0.5) < 1e-8);
  BOOST_TEST(std::abs(rest(critical * (1 + 1e-9), 0.5) + 1.5) < 1e-8);
  BOOST_TEST(std::abs(rest(-critical * (1 - 1e-9), -0.6) + 0.5) < 1e-8);
  BOOST_TEST(std::abs(rest(-critical * (1 + 1e-9), -0.5) - 1.5) < 1e-8);
}

// The buckled range is none of the loop's: there a load lets go of A.
BOOST_AUTO_TEST_CASE(a_buckled_state_leaves_at_the_least_difference) {
  BOOST_TEST(rest_under(system_of_test, 0.2 * k * l, 0.2 + 1e-6).zeta == 0.8,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(rest_under(system_of_test, 0.2 * k * l, 0.2 - 1e-6).zeta == -1.2,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
