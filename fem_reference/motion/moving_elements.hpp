#pragma once

#include <memory>

#include "dynamics/blocks/instruction_set.hpp"
#include "dynamics/marching/march.hpp"
#include "fem_reference/laws/settings.hpp"

namespace springcheck::fem_reference {

struct MotionSettings {
  Settings elements;
  dynamics::Protocol protocol;
  double damping_ratio;  // zeta of the drag, drag.hpp
  int threads = 1;
};

/// Why law, element or integrator do not move the mesh so, or nothing when they do. q2,
/// whose nodes are more than the mesh's, does not move.
std::optional<std::string> reason_to_refuse(const Mesh& mesh, const Scene& scene,
                                            const MotionSettings& settings);

/// What steps the mesh through time.
std::unique_ptr<dynamics::Motion> motion_of(
    const Mesh& mesh, const Scene& scene, const MotionSettings& settings,
    dynamics::InstructionSet set = dynamics::best_instruction_set());

/// Runs elements of any law on any cells by explicit steps and returns the state at the
/// end; see dynamics::march. Their forces are those of the static solver (ElementsBody);
/// masses are lumped to the nodes,
///
///     m_a = rho int N_a dV = rho sum_b int N_a N_b dV   [kg]
///
/// the row sums of the consistent mass matrix, and carry gravity and the drag. Source:
/// row-sum lumping, Hughes, The Finite Element Method (1987), section 7.3.2.
Solution run_dynamics(const Mesh& mesh, const Scene& scene,
                      const MotionSettings& settings,
                      const dynamics::Observers& observers = {});

/// dynamics::largest_stable_step about the rest state.
double largest_stable_step(const Mesh& mesh, const Scene& scene,
                           const MotionSettings& settings);

}  // namespace springcheck::fem_reference
