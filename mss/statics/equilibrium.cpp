#include "mss/statics/equilibrium.hpp"

#include "mss/statics/network_body.hpp"
#include "statics/last_stable_equilibrium.hpp"

namespace springcheck::mss {

Solution find_equilibrium(const Mesh& mesh, const Scene& scene, const Network& network,
                          const statics::Search& search, const Stopwatch& setup) {
  NetworkBody body(network);
  const statics::Loading drive = loading(mesh, scene, network);
  return statics::solution_of(
      search.to_limit
          ? statics::last_stable_equilibrium(body, drive, {mesh.cells(), mesh.cells()},
                                             search.linear_solver, setup)
          : statics::find_equilibrium(body, drive, search, setup));
}

}  // namespace springcheck::mss
