#include "mss/solve.hpp"

#include "mss/equilibrium.hpp"

namespace springcheck::mss {

Solution solve(const Mesh& mesh, const Scene& scene, const Settings& settings) {
  if (const auto reason = reason_to_refuse(mesh, scene.material, settings.network.method))
    return {.status = SolveStatus::refused,
            .reason = *reason,
            .displacements = {},
            .reactions = {},
            .lever_arms = LeverArms::deformed,
            .strain_energy = 0,
            .load_fraction = 0,
            .steps = 0,
            .force_evaluations = 0};
  const Network network = build_network(mesh, scene.material, settings.network);
  return settings.solver == Solver::static_equilibrium
             ? find_equilibrium(mesh, scene, network, settings.seed)
             : run_dynamics(mesh, scene, network, settings.dynamics);
}

}  // namespace springcheck::mss
