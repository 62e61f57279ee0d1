#include "comparisons/methods/protocol.hpp"

#include "statics/systems/linear_solver.hpp"

namespace springcheck {
namespace {

dynamics::Integrator integrator_of(Solver solver) {
  using dynamics::Integrator;
  switch (solver) {
    case Solver::explicit_euler:
      return Integrator::explicit_euler;
    case Solver::verlet:
      return Integrator::verlet;
    case Solver::implicit_euler:
      return Integrator::implicit_euler;
    case Solver::semi_implicit_euler:
    case Solver::static_equilibrium:
    case Solver::path_limit:
      break;
  }
  return Integrator::semi_implicit_euler;
}

}  // namespace

dynamics::Protocol protocol_of(const CaseSettings& settings) {
  return {.integrator = integrator_of(solver_of(settings)),
          .duration = settings.dynamics.duration,
          .time_step = settings.dynamics.time_step,
          .step_ratio = settings.dynamics.step_ratio,
          .force_time_step = settings.dynamics.force_time_step,
          .load = settings.dynamics.load};
}

statics::Search search_of(const CaseSettings& settings) {
  statics::Search search = settings.search;
  search.to_limit = solver_of(settings) == Solver::path_limit;
  return search;
}

LinearSystems::Kind linear_systems_of(const CaseSettings& settings) {
  using enum LinearSystems::Kind;
  if (goes_through_time(settings)) return cholesky;
  const auto [nx, ny, nz] = element_nodes(settings);
  switch (statics::linear_solver_taken(settings.search.linear_solver,
                                       static_cast<std::ptrdiff_t>(3 * nx * ny * nz))) {
    case statics::LinearSolver::conjugate_gradients:
      return conjugate_gradients;
    case statics::LinearSolver::multigrid:
      return multigrid;
    case statics::LinearSolver::direct:
    case statics::LinearSolver::automatic:
      break;
  }
  return cholesky;
}

}  // namespace springcheck
