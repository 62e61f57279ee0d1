#include "mss/statics/equilibrium.hpp"

#include "mss/statics/network_body.hpp"
#include "statics/last_stable_equilibrium.hpp"

namespace springcheck::mss {

Solution find_equilibrium(const Mesh& mesh, const Scene& scene, const Network& network,
                          const statics::Search& search) {
  NetworkBody body(network);
  return statics::solution_of(
      statics::find_equilibrium(body, loading(mesh, scene, network), search));
}

Solution last_stable_equilibrium(const Mesh& mesh, const Scene& scene,
                                 const Network& network) {
  NetworkBody body(network);
  return statics::solution_of(
      statics::last_stable_equilibrium(body, loading(mesh, scene, network), mesh));
}

}  // namespace springcheck::mss
