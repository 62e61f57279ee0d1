#include "fem_reference/statics/takes_multigrid.hpp"

namespace springcheck::fem_reference {

bool takes_multigrid(const Settings& settings, double poisson_ratio,
                     std::size_t components) {
  if (settings.linear_solver != statics::LinearSolver::automatic)
    return settings.linear_solver == statics::LinearSolver::multigrid;
  const std::size_t limit = settings.element == Element::q2 ? 50000 : 25000;
  const bool nearly_incompressible = poisson_ratio > 0.45;
  return components > (nearly_incompressible ? 2 * limit : limit);
}

}  // namespace springcheck::fem_reference
