#include "tissue/thesis_spring.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "meshing/basics/input_error.hpp"
#include "tissue/checks.hpp"

namespace springcheck::tissue {

double hand_fitted_limit(std::string_view organ) {
  constexpr std::array<std::pair<std::string_view, double>, 3> table_4_2{
      {{"kidney", 0.07}, {"liver", 0.45}, {"spleen", 400}}};
  for (const auto& [name, limit] : table_4_2)
    if (name == organ) return limit;
  throw InputError("tissue", "organ", "kidney, liver or spleen", std::string(organ));
}

namespace {

/// T = c e^a (1 + (e/gamma_lim)^(p-a)), e the strain without its sign.
struct Powers {
  double a, p;       // 1-n, and p of the law
  double hardening;  // p - a
};

Powers powers_of(const ThesisSpring& spring, double rest_length) {
  check(spring.law);
  check_positive("strain limit gamma_lim_mss", spring.strain_limit);
  check_positive("rest length [m]", rest_length);
  const double a = 1 - spring.law.linear_index, p = spring.law.hardening_index;
  check_positive("exponent p - (1-n) of the hardening", p - a);
  return {.a = a, .p = p, .hardening = p - a};
}

/// c [N].
double scale_of(const ThesisSpring& spring, double stiffness, double rest_length,
                double a) {
  return stiffness * (spring.elongation == Elongation::relative
                          ? rest_length
                          : std::pow(rest_length, a));
}

}  // namespace

double tension(const ThesisSpring& spring, double stiffness, double rest_length,
               double length, double damping, double elongation_rate) {
  const Powers powers = powers_of(spring, rest_length);
  const double elongation = length - rest_length;
  const double strain = std::abs(elongation) / rest_length;
  const double elastic =
      scale_of(spring, stiffness, rest_length, powers.a) * std::pow(strain, powers.a);
  return (damping * elongation_rate + std::copysign(elastic, elongation)) *
         (1 + std::pow(strain / spring.strain_limit, powers.hardening));
}

double stored_energy(const ThesisSpring& spring, double stiffness, double rest_length,
                     double length) {
  const auto [a, p, hardening] = powers_of(spring, rest_length);
  const double strain = std::abs(length - rest_length) / rest_length;
  return scale_of(spring, stiffness, rest_length, a) * rest_length *
         (std::pow(strain, a + 1) / (a + 1) +
          std::pow(strain, p + 1) / ((p + 1) * std::pow(spring.strain_limit, hardening)));
}

double tangent_stiffness(const ThesisSpring& spring, double stiffness, double rest_length,
                         double length) {
  constexpr double least = 1e-9;
  const auto [a, p, hardening] = powers_of(spring, rest_length);
  const double strain = std::max(std::abs(length - rest_length) / rest_length, least);
  return scale_of(spring, stiffness, rest_length, a) / rest_length *
         (a * std::pow(strain, a - 1) +
          p * std::pow(strain, p - 1) / std::pow(spring.strain_limit, hardening));
}

}  // namespace springcheck::tissue
