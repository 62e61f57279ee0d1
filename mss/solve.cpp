#include "mss/solve.hpp"

#include "mss/equilibrium.hpp"
#include "mss/spring_strain.hpp"

namespace springcheck::mss {

Solution solve(const Mesh& mesh, const Scene& scene, const Settings& settings,
               const dynamics::Observers& observers) {
  if (const auto reason = reason_to_refuse(mesh, scene.material, settings.network.method))
    return refused(*reason);
  const Network network = build_network(mesh, scene.material, settings.network);
  Solution solution =
      settings.dynamics
          ? run_dynamics(mesh, scene, network, *settings.dynamics, observers)
          : find_equilibrium(mesh, scene, network, settings.seed);
  if (!solution.displacements.empty())
    solution.spring_strains = largest_spring_strains(network, solution.displacements);
  return solution;
}

}  // namespace springcheck::mss
