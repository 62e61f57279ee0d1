#include "mss/tissue/tissue_dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dynamics/marching/small_motions.hpp"
#include "dynamics/marching/stable_step.hpp"

namespace springcheck::mss {
namespace {

using dynamics::State;
using Vectors = std::vector<Vector3>;

Vectors positions_in(const TissueBody& body, const Vectors& displacements) {
  Vectors positions = body.rest_positions;
  for (std::size_t n = 0; n < positions.size(); ++n) positions[n] += displacements[n];
  return positions;
}

}  // namespace

std::optional<std::string> reason_to_refuse_tissue(const dynamics::Protocol& protocol,
                                                   const dynamics::Observers& observers) {
  if (protocol.integrator == dynamics::Integrator::implicit_euler)
    return "tissue steps explicitly; implicit Euler's equations are not solved for it";
  if (observers.checkpoint || observers.from)
    return "tissue has no checkpoints: they would have to hold its memories";
  return std::nullopt;
}

Solution run_tissue_dynamics(const Mesh& mesh, const Scene& scene, const TissueBody& body,
                             const dynamics::Protocol& protocol, int threads,
                             const dynamics::Observers& observers,
                             const Stopwatch& setup) {
  if (const auto reason = reason_to_refuse_tissue(protocol, observers))
    return refused(*reason);
  TissueMotion motion(mesh, scene, body,
                      {.integrator = protocol.integrator, .threads = threads});
  const double edge =
      std::cbrt(std::ranges::min_element(body.shapes, {}, &TissueShape::volume)->volume);
  const dynamics::SmallMotions small = dynamics::about_rest(
      body.masses, free_components(mesh, prescribed_components(mesh, scene)), edge,
      body.solid.shear.viscosity > 0);
  double largest_strain = 0;
  const auto look_at_strain = [&] {
    largest_strain = std::max(
        largest_strain,
        largest_shear_strain(body, positions_in(body, motion.state().displacements)));
  };
  Solution solution = dynamics::march(
      {.mesh = mesh,
       .scene = scene,
       .masses = body.masses,
       // March asks for both in the state of the motion alone, and goes on from there:
       // the look restores that very state.
       .forces = {.internal = [&](const State& state) { return motion.forces_at(state); },
                  .strain_energy =
                      [&](std::span<const Vector3>) {
                        return free_energy(
                            body, motion.memories(),
                            positions_in(body, motion.state().displacements));
                      }},
       .stable_step =
           [&](const std::optional<State>& state, const dynamics::StableStep* near) {
             look_at_strain();
             return dynamics::largest_stable_step(small, motion,
                                                  dynamics::Precision::double_precision,
                                                  state, protocol.integrator, near);
           },
       .step_setters = fmt::format(
           "set by a bulk modulus of {:.3g} Pa and more, and "
           "cells of {:.3g} m",
           body.solid.bulk_ratio * tissue::instantaneous_modulus(body.solid.shear), edge),
       .undamped = "without a viscosity the elastic branch swings undamped"},
      motion, protocol, observers, setup);
  if (solution.status == SolveStatus::refused) return solution;
  look_at_strain();
  solution.largest_shear_strain = largest_strain;
  return solution;
}

}  // namespace springcheck::mss
