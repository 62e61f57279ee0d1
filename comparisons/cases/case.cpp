#include "comparisons/cases/case.hpp"

#include <fmt/format.h>

namespace springcheck {

bool has_lower_plate(Test test) {
  return test != Test::affine;
}

bool has_upper_plate(Test test) {
  return test != Test::bending && test != Test::affine;
}

Solver solver_of(const CaseSettings& settings) {
  if (is_finite_element(settings.method)) return Solver::static_equilibrium;
  return settings.solver.value_or(is_explicit_element(settings.method)
                                      ? Solver::semi_implicit_euler
                                      : Solver::static_equilibrium);
}

bool goes_through_time(const CaseSettings& settings) {
  const Solver solver = solver_of(settings);
  return solver != Solver::static_equilibrium && solver != Solver::path_limit;
}

bool has_history(const CaseSettings& settings) {
  return goes_through_time(settings) || is_tissue(settings.method);
}

mss::NetworkSettings network_settings(const CaseSettings& settings) {
  mss::NetworkSettings springs = settings.springs;
  springs.method = std::get<mss::Method>(settings.method.model);
  return springs;
}

fem_reference::Settings reference_settings(const CaseSettings& settings) {
  using fem_reference::SpringConstants;
  const bool from_shear_modulus =
      settings.springs.stiffness_form == mss::StiffnessForm::shear_modulus;
  return {
      .law = std::get<fem_reference::Law>(settings.method.model),
      .element = settings.elements.element.element,
      .lattice = {.springs = settings.elements.lattice.springs,
                  .diagonal_ratio = settings.springs.diagonal_ratio,
                  .constants = from_shear_modulus ? SpringConstants::from_shear_modulus
                                                  : SpringConstants::from_young_modulus,
                  .direction = settings.elements.lattice_direction},
      .linear_solver = settings.elements.linear_solver};
}

std::string label(const CaseSettings& settings) {
  if (is_finite_element(settings.method))
    return fmt::format("{}:{}", settings.method.name, settings.elements.element.name);
  return std::string(settings.method.name);
}

}  // namespace springcheck
