#include "mss/tissue/tissue_dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/small_motions.hpp"
#include "meshing/traction.hpp"

namespace springcheck::mss {
namespace {

using dynamics::State;
using dynamics::StepTo;
using Vectors = std::vector<Vector3>;

class TissueMotion final : public dynamics::Motion {
 public:
  TissueMotion(const Mesh& mesh, const Scene& scene, const TissueBody& body,
               dynamics::Integrator integrator, const Vectors& load)
      : body_(body),
        integrator_(integrator),
        load_(load),
        supports_(dynamics::supports(scene, prescribed_components(mesh, scene))),
        is_free_(free_components(mesh, prescribed_components(mesh, scene))),
        state_{.displacements = Vectors(load.size(), Vector3::Zero()),
               .velocities = Vectors(load.size(), Vector3::Zero())},
        memories_(memories_at_rest(body)),
        stresses_(body.cells.size()),
        forces_(load.size(), Vector3::Zero()) {}

  void advance(const StepTo& step) override {
    for (std::size_t n = 0; n < load_.size(); ++n) {
      const Vector3 acceleration =
          (forces_[n] + step.load_fraction * load_[n]) / body_.masses[n];
      for (int i = 0; i < 3; ++i)
        if (is_free_[3 * n + static_cast<std::size_t>(i)])
          dynamics::step(integrator_, state_.displacements[n][i], state_.velocities[n][i],
                         acceleration[i], step.dt, step.kick);
    }
    for (const auto& [node, component, motion] : supports_) {
      const Vector3& point = body_.rest_positions[node];
      const double now = step.motions[motion].component(point, component);
      state_.velocities[node][component] =
          (now - step.motions_before[motion].component(point, component)) / step.dt;
      state_.displacements[node][component] = now;
    }
    if (step.dt != memory_step_.duration)
      memory_step_ = tissue::memory_step(body_.solid, step.dt);
    const Vectors positions = positions_in(state_);
    mss::advance(body_, memory_step_, memories_, positions, stresses_);
    nodal_forces(body_, stresses_, positions, forces_);
  }

  [[nodiscard]] State state() const override { return state_; }

  /// With the memories as they are.
  [[nodiscard]] Vectors forces_at(const State& state) override {
    const Vectors positions = positions_in(state);
    std::vector<tissue::PointStress> stresses(body_.cells.size());
    stresses_at(body_, memories_, positions, state.velocities, stresses);
    Vectors forces(positions.size());
    nodal_forces(body_, stresses, positions, forces);
    return forces;
  }

  /// Forces and memories stay those of the step made last: no other state is gone on
  /// from (reason_to_refuse_tissue).
  void restore(const State& state) override { state_ = state; }

  [[nodiscard]] const Vectors& forces() const { return forces_; }
  [[nodiscard]] const std::vector<double>& memories() const { return memories_; }

  [[nodiscard]] Vectors positions_in(const State& state) const {
    Vectors positions = body_.rest_positions;
    for (std::size_t n = 0; n < positions.size(); ++n)
      positions[n] += state.displacements[n];
    return positions;
  }

 private:
  const TissueBody& body_;
  dynamics::Integrator integrator_;
  const Vectors& load_;
  std::vector<dynamics::Support> supports_;
  std::vector<bool> is_free_;
  State state_;
  std::vector<double> memories_;
  tissue::MemoryStep memory_step_{.duration = 0, .decays = {}};
  std::vector<tissue::PointStress> stresses_;
  Vectors forces_;
};

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
                             const dynamics::Protocol& protocol,
                             const dynamics::Observers& observers) {
  if (const auto reason = reason_to_refuse_tissue(protocol, observers))
    return refused(*reason);
  Vectors load = traction_forces(mesh, scene);
  for (std::size_t n = 0; n < load.size(); ++n) load[n] += body.masses[n] * scene.gravity;
  TissueMotion motion(mesh, scene, body, protocol.integrator, load);
  const double edge =
      std::cbrt(std::ranges::min_element(body.shapes, {}, &TissueShape::volume)->volume);
  const dynamics::SmallMotions small{
      .forces = {},
      .state = motion.state(),
      .masses = body.masses,
      .is_free = free_components(mesh, prescribed_components(mesh, scene)),
      .amplitude = dynamics::probe * edge,
      .has_dashpots = body.solid.shear.viscosity > 0};
  double largest_strain = 0;
  const auto look_at_strain = [&] {
    largest_strain = std::max(
        largest_strain, largest_shear_strain(body, motion.positions_in(motion.state())));
  };
  Solution solution = dynamics::march(
      {.mesh = mesh,
       .scene = scene,
       .masses = body.masses,
       .load = load,
       // In the state of the motion, where alone march asks for them:
       .forces = {.internal =
                      [&](const State&, std::span<Vector3> forces) {
                        std::ranges::copy(motion.forces(), forces.begin());
                      },
                  .strain_energy =
                      [&](std::span<const Vector3>) {
                        return free_energy(body, motion.memories(),
                                           motion.positions_in(motion.state()));
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
      motion, protocol, observers);
  if (solution.status == SolveStatus::refused) return solution;
  look_at_strain();
  solution.largest_shear_strain = largest_strain;
  return solution;
}

}  // namespace springcheck::mss
