#include "mss/solve.hpp"

#include "mss/equilibrium.hpp"

namespace springcheck::mss {

Solution solve(const Mesh& mesh, const Scene& scene, const Settings& settings) {
  if (const auto reason = reason_to_refuse(mesh, scene.material, settings.network.method))
    return refused(*reason);
  const Network network = build_network(mesh, scene.material, settings.network);
  return settings.solver == Solver::static_equilibrium
             ? find_equilibrium(mesh, scene, network, settings.seed)
             : run_dynamics(mesh, scene, network, settings.dynamics);
}

}  // namespace springcheck::mss
