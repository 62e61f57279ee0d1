#pragma once

#include <memory>
#include <span>

#include "dynamics/blocks/block_state.hpp"
#include "dynamics/blocks/instruction_set.hpp"
#include "dynamics/integrators.hpp"
#include "dynamics/motion.hpp"

namespace springcheck::dynamics {

/// What an explicit motion is made of. Lists hold one entry per node of the mesh; spans
/// are read while it is made, and not later.
template <class Real>
struct ExplicitBody {
  std::span<const Vector3> rest;   // [m]
  std::span<const double> masses;  // [kg]
  std::span<const Vector3> load;   // [N] at the full load
  std::vector<Support> supports;
  std::vector<Block> blocks;  // every node in at least one
  BlockForces<Real> forces;
};

struct ExplicitSettings {
  Integrator integrator;  // not the implicit one
  InstructionSet instruction_set;
  int threads;
};

/// Steps the body from rest, block by block, each with its own copy of the nodes it
/// shares. A step sums the forces on shared nodes over their blocks in the blocks' order,
/// moves the nodes and computes the next forces: one wait for all threads per step, two
/// where forces need nodal sums, and the same bits on any number of them.
template <class Real>
std::unique_ptr<Motion> explicit_motion(ExplicitBody<Real> body,
                                        const ExplicitSettings& settings);

}  // namespace springcheck::dynamics
