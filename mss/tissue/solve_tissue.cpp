#include "mss/tissue/solve_tissue.hpp"

#include "mss/tissue/tissue_dynamics.hpp"

namespace springcheck::mss {

Solution solve_tissue(const Mesh& mesh, const Scene& scene,
                      const TissueSettings& settings,
                      const dynamics::Observers& observers, const Stopwatch& setup) {
  const TissueBody body = build_tissue_body(mesh, settings.solid, scene.material.density);
  return settings.protocol ? run_tissue_dynamics(mesh, scene, body, *settings.protocol,
                                                 settings.threads, observers, setup)
                           : find_quasi_static(mesh, scene, body, settings.quasi_static,
                                               observers, setup);
}

}  // namespace springcheck::mss
