#include "fem_reference/statics/linear_solver_taken.hpp"

namespace springcheck::fem_reference {

statics::LinearSolver linear_solver_taken(const Settings& settings, double poisson_ratio,
                                          std::size_t components) {
  using enum statics::LinearSolver;
  if (settings.linear_solver != automatic) return settings.linear_solver;
  const std::size_t limit = settings.element == Element::q2 ? 50000 : 25000;
  const bool nearly_incompressible = poisson_ratio > 0.45;
  return components > (nearly_incompressible ? 2 * limit : limit) ? multigrid : direct;
}

}  // namespace springcheck::fem_reference
