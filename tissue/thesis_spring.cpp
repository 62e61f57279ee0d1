#include "tissue/thesis_spring.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "meshing/input_error.hpp"
#include "tissue/checks.hpp"

namespace springcheck::tissue {

double hand_fitted_limit(std::string_view organ) {
  constexpr std::array<std::pair<std::string_view, double>, 3> table_4_2{
      {{"kidney", 0.07}, {"liver", 0.45}, {"spleen", 400}}};
  for (const auto& [name, limit] : table_4_2)
    if (name == organ) return limit;
  throw InputError("tissue", "organ", "kidney, liver or spleen", std::string(organ));
}

double tension(const ThesisSpring& spring, double stiffness, double rest_length,
               double length, double damping, double elongation_rate) {
  check(spring.law);
  check_positive("strain limit gamma_lim_mss", spring.strain_limit);
  check_positive("rest length [m]", rest_length);
  const double linear = 1 - spring.law.linear_index,
               hardening = spring.law.hardening_index - linear;
  check_positive("exponent p - (1-n) of the hardening", hardening);
  const double elongation = length - rest_length;
  const double strain = std::abs(elongation) / rest_length;
  const double elastic = spring.elongation == Elongation::relative
                             ? rest_length * std::pow(strain, linear)
                             : std::pow(std::abs(elongation), linear);
  return (damping * elongation_rate + stiffness * std::copysign(elastic, elongation)) *
         (1 + std::pow(strain / spring.strain_limit, hardening));
}

}  // namespace springcheck::tissue
