#include "tissue/bipower_law.hpp"

#include <fmt/ranges.h>
#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include <algorithm>
#include <ranges>

#include "meshing/basics/input_error.hpp"
#include "tissue/checks.hpp"

namespace springcheck::tissue {
namespace {

constexpr std::array<Organ, 3> table_4_1{{
    {"liver", {861, 0.1138, 0.40, 4.17}},
    {"kidney", {1818, 0.0892, 0.11, 2.64}},
    {"spleen", {758, 0.1043, 0.73, 1.6}},
}};

/// int_0^T u^p (u+s)^-n du, as T^(p+1)/(p+1) times the mean of (u+s)^-n over
/// v = (u/T)^(p+1), which leaves no steep integrand.
double hardening_integral(double p, double n, double T, double s) {
  // integrate() is not const in Boost 1.74.
  thread_local boost::math::quadrature::tanh_sinh<double> quadrature;
  const auto power = [&](double v) {
    return std::pow(T * std::pow(v, 1 / (p + 1)) + s, -n);
  };
  constexpr double tolerance = 1e-10;
  return std::pow(T, p + 1) / (p + 1) * quadrature.integrate(power, 0., 1., tolerance);
}

}  // namespace

void check(const BipowerLaw& law) {
  check_positive("consistency K [Pa s^n]", law.consistency);
  check_positive("linear limit gamma_lim", law.linear_limit);
  check_positive("hardening index p", law.hardening_index);
  if (!(law.linear_index > 0 && law.linear_index < 1)) {
    std::ostringstream got;
    got << law.linear_index;
    throw InputError("tissue", "linear index n", "a number above 0 and below 1",
                     got.str());
  }
}

std::span<const Organ> organs() {
  return table_4_1;
}

BipowerLaw law_of_organ(std::string_view name) {
  const auto found = std::ranges::find(table_4_1, name, &Organ::name);
  if (found != std::end(table_4_1)) return found->law;
  throw InputError(
      "tissue", "organ",
      fmt::format("one of {}",
                  fmt::join(table_4_1 | std::views::transform(&Organ::name), ", ")),
      fmt::format("'{}'", name));
}

double linear_relaxation_modulus(const BipowerLaw& law, double time) {
  check(law);
  check_positive("time [s]", time);
  const double n = law.linear_index;
  return law.consistency / std::tgamma(1 - n) * std::pow(time, -n);
}

double hardened_strain(const BipowerLaw& law, double strain) {
  check(law);
  const double p = law.hardening_index;
  return strain * (1 + std::pow(std::abs(strain / law.linear_limit), p) / (p + 1));
}

ShearStress constant_rate_stress(const BipowerLaw& law, double strain, double rate) {
  check(law);
  check_not_negative("strain", strain);
  check_positive("strain rate [1/s]", rate);
  const double n = law.linear_index, p = law.hardening_index;
  const double linear =
      law.consistency * std::pow(rate, n) * std::pow(strain, 1 - n) / std::tgamma(2 - n);
  return {linear,
          linear * (1 - n) / (p + 1 - n) * std::pow(strain / law.linear_limit, p)};
}

ShearStress ramp_and_hold_stress(const BipowerLaw& law, double strain, double rate,
                                 double time_held) {
  check(law);
  check_not_negative("strain", strain);
  check_positive("strain rate [1/s]", rate);
  check_not_negative("time held [s]", time_held);
  if (strain == 0) return {0, 0};
  const double n = law.linear_index, p = law.hardening_index;
  const double T = strain / rate, s = time_held;
  // (s+T)^(1-n) - s^(1-n), without cancellation where s is much longer than T.
  const double powers =
      s == 0 ? std::pow(T, 1 - n)
             : std::pow(s, 1 - n) * std::expm1((1 - n) * std::log1p(T / s));
  return {law.consistency * rate / std::tgamma(2 - n) * powers,
          law.consistency * rate / std::tgamma(1 - n) *
              std::pow(rate / law.linear_limit, p) * hardening_integral(p, n, T, s)};
}

ShearStress ideal_step_stress(const BipowerLaw& law, double strain, double time) {
  const double G = linear_relaxation_modulus(law, time);
  return {G * strain, G * (hardened_strain(law, strain) - strain)};
}

ComplexModulus small_oscillation(const BipowerLaw& law, double angular_frequency) {
  check(law);
  check_positive("angular frequency [rad/s]", angular_frequency);
  const double n = law.linear_index;
  const double modulus = law.consistency * std::pow(angular_frequency, n);
  const double angle = n * std::numbers::pi / 2;
  return {modulus * std::cos(angle), modulus * std::sin(angle)};
}

}  // namespace springcheck::tissue
