#include "comparisons/modes/beam_frequencies.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

namespace springcheck {
namespace {

using std::numbers::pi;

/// f of a number b [Hz].
double bending_frequency(const SquareCantilever& beam, double b) {
  const auto& [E, nu, rho] = beam.material;
  const double radius_of_gyration = beam.edge / std::sqrt(12);
  return b / (2 * pi * beam.length * beam.length) * std::sqrt(E / rho) *
         radius_of_gyration;
}

/// The n-th root below `end`; roots lie farther apart than the step.
double root(const std::function<double(double)>& equation, int n, double end) {
  constexpr double step = 0.25;
  for (double from = step; from + step < end; from += step)
    if (equation(from) * equation(from + step) < 0 && --n == 0) {
      std::uintmax_t evaluations = 100;
      const auto [low, high] = boost::math::tools::toms748_solve(
          equation, from, from + step, boost::math::tools::eps_tolerance<double>(50),
          evaluations);
      return (low + high) / 2;
    }
  throw std::domain_error("no such bending mode within the beam theory's validity");
}

double quarter_wave(double length, int n, double speed) {
  return (2 * n - 1) / (4 * length) * speed;
}

}  // namespace

double euler_bernoulli_frequency(const SquareCantilever& beam, int n) {
  const auto equation = [](double b) {
    return 1 + std::cosh(std::sqrt(b)) * std::cos(std::sqrt(b));
  };
  const double beyond = std::pow(n * pi, 2);  // the roots tend to ((n - 1/2) pi)^2
  return bending_frequency(beam, root(equation, n, beyond));
}

double timoshenko_frequency(const SquareCantilever& beam, int n) {
  constexpr double shear_factor = 5. / 6;
  const double G = lame_constants(beam.material).mu;
  const double r2 = std::pow(beam.edge / beam.length, 2) / 12,
               s2 = r2 * beam.material.young_modulus / (shear_factor * G);
  const auto equation = [&](double b) {
    const double common = std::sqrt(std::pow(r2 - s2, 2) + 4 / (b * b));
    const double alpha = std::sqrt((common - r2 - s2) / 2),
                 beta = std::sqrt((common + r2 + s2) / 2);
    return 2 +
           (std::pow(b * (r2 - s2), 2) + 2) * std::cosh(b * alpha) * std::cos(b * beta) -
           b * (r2 + s2) / std::sqrt(1 - b * b * r2 * s2) * std::sinh(b * alpha) *
               std::sin(b * beta);
  };
  return bending_frequency(beam, root(equation, n, 1 / std::sqrt(r2 * s2)));
}

double torsion_frequency(const SquareCantilever& beam, int n) {
  constexpr double J_over_polar_moment = 6 * 0.140577;
  const double G = lame_constants(beam.material).mu;
  return quarter_wave(beam.length, n,
                      std::sqrt(G / beam.material.density * J_over_polar_moment));
}

double stretching_frequency(const SquareCantilever& beam, int n) {
  return quarter_wave(beam.length, n,
                      std::sqrt(beam.material.young_modulus / beam.material.density));
}

}  // namespace springcheck
