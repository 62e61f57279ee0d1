#include "mss/networks/strain_measure.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>

using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(strain_measure_test)

namespace {

constexpr StrainMeasure measures[] = {StrainMeasure::engineering, StrainMeasure::green,
                                      StrainMeasure::logarithmic};
constexpr double k = 3, L = 2;
constexpr double lengths[] = {0.5, 1.9, 2, 2.3, 5};

/// Central difference with a step of 1e-4: truncation of about 1e-9, round-off 1e-12.
double slope(const std::function<double(double)>& f, double at) {
  constexpr double step = 1e-4;
  return (f(at + step) - f(at - step)) / (2 * step);
}
const auto as_slopes = boost::test_tools::tolerance(1e-6);

}  // namespace

// By hand at twice the length: s = 1, 3/2, ln 2.
BOOST_AUTO_TEST_CASE(energy_is_quadratic_in_the_strain,
                     *boost::unit_test::tolerance(1e-14)) {
  const double unit = k * L * L / 2;
  BOOST_TEST(spring_energy(measures[0], k, L, 2 * L) == unit);
  BOOST_TEST(spring_energy(measures[1], k, L, 2 * L) == unit * 9 / 4);
  BOOST_TEST(spring_energy(measures[2], k, L, 2 * L) == unit * std::pow(std::log(2.), 2));
}

BOOST_AUTO_TEST_CASE(pulls_are_slopes_of_the_energy) {
  for (const StrainMeasure measure : measures)
    for (const double l : lengths) {
      const auto tension = [&](double length) {
        return k * length * spring_pull(measure, L, length).over_length;
      };
      const double by_energy =
          slope([&](double length) { return spring_energy(measure, k, L, length); }, l);
      BOOST_TEST(std::abs(tension(l) - by_energy) < 1e-6 * k * L);
      BOOST_TEST(k * spring_pull(measure, L, l).slope == slope(tension, l), as_slopes);
    }
}

// From 2 to l, of which the energy of springs at a constant length is a case.
BOOST_AUTO_TEST_CASE(elongations_and_their_slopes_go_together) {
  for (const StrainMeasure measure : measures)
    for (const double l : lengths) {
      const auto e = [&](double length) {
        return elongation(measure, L, length * length - L * L, length, L);
      };
      BOOST_TEST(k / 2 * e(l) * e(l) == spring_energy(measure, k, L, l),
                 boost::test_tools::tolerance(1e-13));
      BOOST_TEST(elongation_slopes(measure, L, l).first == slope(e, l), as_slopes);
      const double second = slope(
          [&](double length) { return elongation_slopes(measure, L, length).first; }, l);
      BOOST_TEST(std::abs(elongation_slopes(measure, L, l).second - second) < 1e-6);
    }
}

// 1e-12 of the length: all the same, to the digits that its square has beyond 1e-12.
BOOST_AUTO_TEST_CASE(small_elongations_are_the_same_and_keep_their_digits) {
  constexpr double e = 1e-12;
  for (const StrainMeasure measure : measures)
    BOOST_TEST(elongation(measure, L, e * (2 * L + e), L + e, L) == e,
               boost::test_tools::tolerance(2e-12));
}

BOOST_AUTO_TEST_CASE(volume_pulls_are_slopes_of_the_energy) {
  for (const StrainMeasure measure : measures)
    for (const double t : {-0.5, -0.1, 1e-9, 0.3, 4.}) {
      const double by_energy =
          slope([&](double change) { return volume_energy(measure, k, change); }, t);
      BOOST_TEST(std::abs(k * volume_pull(measure, t).first - by_energy) < 1e-6);
      const double by_pull =
          slope([&](double change) { return volume_pull(measure, change).first; }, t);
      BOOST_TEST(std::abs(volume_pull(measure, t).second - by_pull) < 1e-6);
    }
}

// A cell turned inside out has no logarithm of its volume, a spring of no length none of
// its length: no minimum is sought there, and no force is not a number.
BOOST_AUTO_TEST_CASE(what_has_no_logarithm_has_infinite_energy_and_no_pull) {
  constexpr auto logarithmic = StrainMeasure::logarithmic;
  BOOST_TEST(std::isinf(spring_energy(logarithmic, k, L, 0)));
  for (const double t : {-1., -1.5}) {
    BOOST_TEST(std::isinf(volume_energy(logarithmic, k, t)));
    BOOST_TEST(volume_energy(logarithmic, -k, t) > 0);
    BOOST_TEST(volume_pull(logarithmic, t).first == 0);
    BOOST_TEST(volume_pull(logarithmic, t).second == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
