#include "comparisons/methods/protocol.hpp"

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

}  // namespace springcheck
