#include "mss/tissue/solve_tissue.hpp"

#include "meshing/stopwatch.hpp"
#include "mss/tissue/tissue_dynamics.hpp"

namespace springcheck::mss {

Solution solve_tissue(const Mesh& mesh, const Scene& scene,
                      const TissueSettings& settings,
                      const dynamics::Observers& observers) {
  const Stopwatch stopwatch;
  const TissueBody body = build_tissue_body(mesh, settings.solid, scene.material.density);
  const double setup_wall_s = stopwatch.seconds();
  Solution solution =
      settings.protocol
          ? run_tissue_dynamics(mesh, scene, body, *settings.protocol, settings.threads,
                                observers)
          : find_quasi_static(mesh, scene, body, settings.quasi_static, observers);
  solution.setup_wall_s += setup_wall_s;
  return solution;
}

}  // namespace springcheck::mss
