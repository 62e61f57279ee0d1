#include <boost/test/unit_test.hpp>
#include <cmath>

#include "comparisons/measures/beam_theory.hpp"
#include "tests/referee/figures.hpp"

using namespace springcheck;
namespace utf = boost::unit_test;

BOOST_AUTO_TEST_SUITE(beam_theory_test)

namespace {

/// The beam of the thesis's figures, 0.4 x 0.4 x 2.4 m, rho = 1000, g = 10, nu = .25.
Cantilever thesis_beam(double young) {
  return {.length = 2.4,
          .width = 0.4,
          .height = 0.4,
          .young_modulus = young,
          .shear_modulus = young / 2.5,
          .load_per_length = 1000 * 10 * 0.4 * 0.4};
}

}  // namespace

// w L^4 / (8 E I), exact on paper.
BOOST_AUTO_TEST_CASE(euler_bernoulli_tip_drops_by_w_l4_over_8_ei,
                     *utf::tolerance(1e-12)) {
  Cantilever beam = thesis_beam(2e6);
  beam.width = 0.3;
  beam.load_per_length = 1200;
  const double EI = 2e6 * 0.3 * std::pow(0.4, 3) / 12;
  BOOST_TEST(euler_bernoulli(beam, 2.4).drop == 1200 * std::pow(2.4, 4) / (8 * EI));
  BOOST_TEST(euler_bernoulli(beam, 0).drop == 0);
  BOOST_TEST(euler_bernoulli(beam, 1.2).axial == 1.2);
}

// y'''' = w/EI by central differences; 1e-4 is their error at this spacing.
BOOST_AUTO_TEST_CASE(euler_bernoulli_obeys_the_beam_equation, *utf::tolerance(1e-4)) {
  const Cantilever beam = thesis_beam(2e6);
  const double h = 0.05, s = 1;
  const auto y = [&](double at) { return euler_bernoulli(beam, at).drop; };
  const double fourth =
      (y(s - 2 * h) - 4 * y(s - h) + 6 * y(s) - 4 * y(s + h) + y(s + 2 * h)) /
      std::pow(h, 4);
  BOOST_TEST(fourth == beam.load_per_length / (2e6 * std::pow(0.4, 4) / 12));
}

// w L^2 / (2 * 5/6 G A), exact on paper.
BOOST_AUTO_TEST_CASE(timoshenko_adds_the_shear_drop, *utf::tolerance(1e-12)) {
  const Cantilever beam = thesis_beam(2e6);
  BOOST_TEST(timoshenko(beam, 2.4).drop - euler_bernoulli(beam, 2.4).drop ==
             1600 * 2.4 * 2.4 / (2 * 5. / 6 * 8e5 * 0.16));
}

// Ours to a step of shooting of its own, the referee's to 1e-11.
BOOST_AUTO_TEST_CASE(elastica_has_the_referee_s_tips, *utf::tolerance(1e-8)) {
  BOOST_TEST(elastica(thesis_beam(10e6), {2.4}).front().drop ==
             referee::figure("elastica", "E 1e+07", "drop of the tip"));
  BOOST_TEST(elastica(thesis_beam(2e6), {2.4}).front().drop ==
             referee::figure("elastica", "E 2e+06", "drop of the tip"));
}

// A stiff beam deflects by 1e-4 of its length: the theories differ by that squared.
BOOST_AUTO_TEST_CASE(elastica_is_euler_bernoulli_for_small_deflections,
                     *utf::tolerance(1e-6)) {
  const Cantilever beam = thesis_beam(1e10);
  const auto points = elastica(beam, {0.0, 0.6, 1.2, 2.4});
  BOOST_TEST(points[0].drop == 0);
  BOOST_TEST(points[1].drop == euler_bernoulli(beam, 0.6).drop);
  BOOST_TEST(points[3].drop == euler_bernoulli(beam, 2.4).drop);
}

// Inextensible: chords of 1 mm are as long as their arcs to second order in curvature * 1
// mm.
BOOST_AUTO_TEST_CASE(elastica_keeps_its_length, *utf::tolerance(1e-6)) {
  std::vector<double> s;
  for (int i = 0; i <= 2400; ++i) s.push_back(2.4 * i / 2400);
  const auto points = elastica(thesis_beam(2e6), s);
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    length += std::hypot(points[i].drop - points[i - 1].drop,
                         points[i].axial - points[i - 1].axial);
  BOOST_TEST(length == 2.4);
}

BOOST_AUTO_TEST_SUITE_END()
