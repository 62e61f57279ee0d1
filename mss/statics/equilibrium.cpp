#include "mss/statics/equilibrium.hpp"

#include "mss/statics/network_body.hpp"
#include "statics/last_stable_equilibrium.hpp"
#include "statics/systems/nodal_vectors.hpp"

namespace springcheck::mss {
namespace {

Solution solution_of(const statics::Equilibrium& found) {
  return {.status = found.status,
          .reason = found.reason,
          .displacements = statics::by_node(found.displacements),
          .reactions = statics::by_node(found.reactions),
          .lever_arms = LeverArms::deformed,
          .strain_energy = found.strain_energy,
          .load_fraction = found.load_fraction,
          .steps = found.steps,
          .force_evaluations = found.force_evaluations,
          .definite_up_to = found.definite_up_to,
          .critical_wavelength = found.critical_wavelength,
          .linear_iterations = found.linear_iterations,
          .factorisations = found.factorisations,
          .setup_wall_s = found.setup_wall_s};
}

}  // namespace

Solution find_equilibrium(const Mesh& mesh, const Scene& scene, const Network& network,
                          const statics::Search& search) {
  NetworkBody body(network);
  return solution_of(
      statics::find_equilibrium(body, loading(mesh, scene, network), search));
}

Solution last_stable_equilibrium(const Mesh& mesh, const Scene& scene,
                                 const Network& network) {
  NetworkBody body(network);
  return solution_of(
      statics::last_stable_equilibrium(body, loading(mesh, scene, network), mesh));
}

}  // namespace springcheck::mss
