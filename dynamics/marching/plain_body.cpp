#include "dynamics/marching/plain_body.hpp"

#include <fmt/format.h>

namespace springcheck::dynamics {
namespace {

SmallMotions small_motions(const PlainBody& body) {
  return about_rest(
      body.masses,
      free_components(body.mesh, prescribed_components(body.mesh, body.scene)),
      body.mesh.mean_cell_edge(), body.damping_ratio > 0);
}

}  // namespace

Solution march(const PlainBody& body, Motion& motion, Precision precision,
               const Protocol& protocol, const Observers& observers,
               const Stopwatch& setup) {
  const SmallMotions small = small_motions(body);
  return march({.mesh = body.mesh,
                .scene = body.scene,
                .masses = body.masses,
                .forces = body.forces,
                .stable_step =
                    [&](const std::optional<State>& state, const StableStep* near) {
                      return largest_stable_step(small, motion, precision, state,
                                                 protocol.integrator, near);
                    },
                .step_setters = fmt::format(
                    "set by nu = {:g}, cells of {:.3g} m and a damping ratio of {:g}",
                    body.scene.material.poisson_ratio, body.mesh.mean_cell_edge(),
                    body.damping_ratio),
                .undamped = body.undamped,
                .lever_arms = body.lever_arms},
               motion, protocol, observers, setup);
}

double largest_stable_step(const PlainBody& body, Integrator integrator) {
  SmallMotions small = small_motions(body);
  small.forces = body.forces.internal;
  return largest_stable_step(small, integrator);
}

}  // namespace springcheck::dynamics
