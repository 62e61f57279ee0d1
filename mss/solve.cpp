#include "mss/solve.hpp"

#include "meshing/basics/stopwatch.hpp"
#include "mss/networks/spring_strain.hpp"
#include "mss/statics/equilibrium.hpp"

namespace springcheck::mss {

Solution solve(const Mesh& mesh, const Scene& scene, const Settings& settings,
               const dynamics::Observers& observers) {
  if (const auto reason = reason_to_refuse(mesh, scene.material, settings.network.model))
    return refused(*reason);
  const Stopwatch setup;
  const Network network = build_network(mesh, scene.material, settings.network);
  const auto solved = [&] {
    if (settings.dynamics)
      return run_dynamics(mesh, scene, network, *settings.dynamics, observers, setup);
    return find_equilibrium(mesh, scene, network, settings.search, setup);
  };
  Solution solution = solved();
  if (!solution.displacements.empty())
    solution.spring_strains = largest_spring_strains(network, solution.displacements);
  return solution;
}

}  // namespace springcheck::mss
