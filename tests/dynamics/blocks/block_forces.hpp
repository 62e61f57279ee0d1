#pragma once

#include <vector>

#include "dynamics/blocks/explicit_motion.hpp"

namespace springcheck::dynamics {

/// The forces of a kernel on every node [N], summed over the blocks.
template <class Real>
std::vector<Vector3> summed_forces(const std::vector<Block>& blocks,
                                   BlockForces<Real> forces, InstructionSet set,
                                   const State& state, std::span<const double> masses) {
  const std::vector<Vector3> none(masses.size(), Vector3::Zero());
  return explicit_motion<Real>({.rest = none,
                                .masses = masses,
                                .load = none,
                                .supports = {},
                                .blocks = blocks,
                                .forces = std::move(forces)},
                               {.integrator = Integrator::semi_implicit_euler,
                                .instruction_set = set,
                                .threads = 1})
      ->forces_at(state);
}

}  // namespace springcheck::dynamics
