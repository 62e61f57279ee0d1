#include "mss/networks/strain_measure.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>

#include "tests/mss/blocks.hpp"

using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(strain_measure_test)

namespace {

constexpr double k = 3, L = 2;
constexpr double lengths[] = {0.5, 1.9, 2, 2.3, 5};

/// The slope by four values around, of step 1e-3: truncation is of the order of 1e-12
/// times the fifth derivative, which reaches 1e5 where springs are at a quarter of their
/// length; round-off is 1e-13.
double slope(const std::function<double(double)>& f, double at) {
  constexpr double step = 1e-3;
  return (8 * (f(at + step) - f(at - step)) - f(at + 2 * step) + f(at - 2 * step)) /
         (12 * step);
}
const auto as_slopes = boost::test_tools::tolerance(1e-6);

}  // namespace

// At twice the length s is 1, 3/2 and ln 2 by hand.
BOOST_AUTO_TEST_CASE(energy_is_quadratic_in_the_strain,
                     *boost::unit_test::tolerance(1e-14)) {
  const double unit = k * L * L / 2;
  const auto energy = [](StrainMeasure measure) {
    return spring_energy(measure, k, L, 2 * L);
  };
  BOOST_TEST(energy(StrainMeasure::engineering) == unit);
  BOOST_TEST(energy(StrainMeasure::green) == unit * 9 / 4);
  BOOST_TEST(energy(StrainMeasure::logarithmic) == unit * std::pow(std::log(2.), 2));
}

BOOST_AUTO_TEST_CASE(pulls_are_slopes_of_the_energy) {
  for (const StrainMeasure measure : all_measures)
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

// The energy is found by Simpson's rule from 1 to 1.2 and to .8, with a truncation of
// about 1e-10. On paper a spring's pull is largest at lambda^2 = (.8 + sqrt(.64 + 4 .9
// 2.1))/1.8.
BOOST_AUTO_TEST_CASE(springs_of_henckys_lattice_have_the_fitted_pull) {
  for (const double end : {1.2, .8}) {
    const auto pull = [](double stretch) {  // over k L^2
      const double square = stretch * stretch;
      return (square - 1) / (2 * square * (.7 + .3 * square)) / stretch;
    };
    constexpr int pieces = 200;
    const double step = (end - 1) / pieces;
    double energy = 0;
    for (int i = 0; i < pieces; ++i) {
      const double at = 1 + i * step;
      energy += step / 6 * (pull(at) + 4 * pull(at + step / 2) + pull(at + step));
    }
    BOOST_TEST(spring_energy(StrainMeasure::hencky, k, L, end * L) == k * L * L * energy,
               boost::test_tools::tolerance(1e-8));
  }
  const double largest = L * std::sqrt((.8 + std::sqrt(.64 + 3.6 * 2.1)) / 1.8);
  BOOST_TEST(std::abs(spring_pull(StrainMeasure::hencky, L, largest).slope) < 1e-15);
}

// At strains of 1e-9 the energy is quadratic: the cubic term is 1e-9 of it.
BOOST_AUTO_TEST_CASE(small_energies_keep_their_digits,
                     *boost::unit_test::tolerance(1e-8)) {
  for (const StrainMeasure measure : all_measures)
    for (const double e : {1e-9, -1e-9}) {
      const double rounded = (L + e) - L;  // what a length of 2 can tell of it
      BOOST_TEST(spring_energy(measure, k, L, L + e) == k / 2 * rounded * rounded);
    }
}

// The elongations go from 2 to l; the energy of springs at a constant length is a case of
// them.
BOOST_AUTO_TEST_CASE(elongations_and_their_slopes_go_together) {
  for (const StrainMeasure measure : all_measures)
    for (const double l : lengths) {
      const auto e = [&](double length) {
        return elongation(measure, L, length * length - L * L, length, L);
      };
      if (measure != StrainMeasure::hencky)  // there the elongation is the logarithm's
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
  for (const StrainMeasure measure : all_measures)
    BOOST_TEST(elongation(measure, L, e * (2 * L + e), L + e, L) == e,
               boost::test_tools::tolerance(2e-12));
}

BOOST_AUTO_TEST_CASE(volume_pulls_are_slopes_of_the_energy) {
  constexpr VolumeModuli moduli{.kappa = -3, .cubic = 2};
  for (const StrainMeasure measure : all_measures)
    for (const double t : {-0.7, -0.4, -0.1, 1e-9, 0.3, 4.}) {
      const auto first = [&](double change) {
        const VolumePull pull = volume_pull(measure, moduli, change);
        return pull.modulus * pull.first;
      };
      const double by_energy =
          slope([&](double change) { return volume_energy(measure, moduli, change); }, t);
      BOOST_TEST(std::abs(first(t) - by_energy) < 1e-6);
      const VolumePull pull = volume_pull(measure, moduli, t);
      BOOST_TEST(std::abs(pull.modulus * pull.second - slope(first, t)) < 1e-6);
    }
}

// With hencky the volume term behaves as in Hencky's law, whatever kappa: ln^3 alone
// would fall without bound. The slopes go on at J = 1/2; both sides of it differ by what
// 1e-9 changes.
BOOST_AUTO_TEST_CASE(no_cell_is_pressed_to_nothing_by_its_volume_term) {
  for (const double kappa : {-3., 0., 3.}) {
    const VolumeModuli moduli{.kappa = kappa, .cubic = 2};
    const auto energy = [&](double J) {
      return volume_energy(StrainMeasure::hencky, moduli, J - 1);
    };
    BOOST_TEST(energy(1e-6) > energy(1e-4));
    BOOST_TEST(energy(1e-6) > 100);
    const VolumePull above = volume_pull(StrainMeasure::hencky, moduli, -0.5 + 1e-9),
                     below = volume_pull(StrainMeasure::hencky, moduli, -0.5 - 1e-9);
    BOOST_TEST(std::abs(energy(0.5 + 1e-9) - energy(0.5 - 1e-9)) < 1e-7);
    BOOST_TEST(std::abs(above.first - below.first) < 1e-6);
    BOOST_TEST(std::abs(above.second - below.second) < 1e-6);
  }
}

// A cell turned inside out has no logarithm of its volume, a spring of no length none of
// its length: no step ends there, and no force is not a number.
BOOST_AUTO_TEST_CASE(what_has_no_logarithm_has_infinite_energy_and_no_pull) {
  for (const auto measure : {StrainMeasure::logarithmic, StrainMeasure::hencky}) {
    BOOST_TEST(std::isinf(spring_energy(measure, k, L, 0)));
    for (const double t : {-1., -1.5}) {
      BOOST_TEST(std::isinf(volume_energy(measure, {.kappa = k}, t)));
      BOOST_TEST(volume_energy(measure, {.kappa = -k}, t) > 0);
      BOOST_TEST(volume_pull(measure, {.kappa = k}, t).first == 0);
      BOOST_TEST(volume_pull(measure, {.kappa = k}, t).second == 0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
