#include "comparisons/measures/beam_theory.hpp"

#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>

namespace springcheck {
namespace {

double bending_stiffness(const Cantilever& beam) {
  return beam.young_modulus * beam.width * std::pow(beam.height, 3) / 12;
}

using State = std::array<double, 4>;  // theta, theta', drop, axial

/// Integrates the elastica from the clamp with the curvature given there, and returns
/// the states at `s`.
std::vector<State> shoot(const Cantilever& beam, double curvature,
                         const std::vector<double>& s) {
  namespace odeint = boost::numeric::odeint;
  const double w_over_EI = beam.load_per_length / bending_stiffness(beam);
  const auto slope = [&](const State& y, State& rate, double at) {
    rate = {y[1], -w_over_EI * (beam.length - at) * std::cos(y[0]), std::sin(y[0]),
            std::cos(y[0])};
  };
  const auto stepper =
      odeint::make_dense_output<odeint::runge_kutta_dopri5<State>>(1e-12, 1e-12);
  std::vector<State> states;
  State y{0, curvature, 0, 0};
  odeint::integrate_times(stepper, slope, y, s.begin(), s.end(), beam.length / 100,
                          [&](const State& state, double) { states.push_back(state); });
  return states;
}

}  // namespace

BeamPoint euler_bernoulli(const Cantilever& beam, double s) {
  const double L = beam.length;
  return {.drop = beam.load_per_length / (24 * bending_stiffness(beam)) *
                  (std::pow(s, 4) - 4 * L * std::pow(s, 3) + 6 * L * L * s * s),
          .axial = s};
}

BeamPoint timoshenko(const Cantilever& beam, double s) {
  constexpr double shear_factor = 5. / 6;
  const double shear_stiffness =
      shear_factor * beam.shear_modulus * beam.width * beam.height;
  return {.drop = euler_bernoulli(beam, s).drop +
                  beam.load_per_length / shear_stiffness * (beam.length * s - s * s / 2),
          .axial = s};
}

std::vector<BeamPoint> elastica(const Cantilever& beam, const std::vector<double>& s) {
  const std::vector<double> ends{0, beam.length};
  const auto end_moment = [&](double curvature) {
    return shoot(beam, curvature, ends).back()[1];
  };
  // With cos theta <= 1 the clamp's moment is at most that of the straight beam.
  const double straight =
      beam.load_per_length * beam.length * beam.length / 2 / bending_stiffness(beam);
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      end_moment, 0., straight * (1 + 1e-6),
      boost::math::tools::eps_tolerance<double>(48), iterations);

  // Integration starts at the clamp, and no two of its stations may be equal.
  std::vector<double> stations(s.begin(), s.end());
  const bool from_clamp = !s.empty() && s.front() == 0;
  if (!from_clamp) stations.insert(stations.begin(), 0);
  const auto states = shoot(beam, (bracket.first + bracket.second) / 2, stations);
  std::vector<BeamPoint> points;
  for (std::size_t i = from_clamp ? 0 : 1; i < states.size(); ++i)
    points.push_back({.drop = states[i][2], .axial = states[i][3]});
  return points;
}

}  // namespace springcheck
