#pragma once

#include <memory>
#include <span>

#include "dynamics/blocks/instruction_set.hpp"
#include "dynamics/integrators.hpp"
#include "dynamics/motion.hpp"

namespace springcheck::dynamics {

/// Explicit steps of a mesh as a single block, with forces that need no kernel. Lists
/// hold one entry per node: masses [kg], and the load at the full load [N].
std::unique_ptr<Motion> plain_motion(const Mesh& mesh, const Scene& scene,
                                     std::span<const double> masses,
                                     std::span<const Vector3> load, ForcesAt forces,
                                     Integrator integrator, InstructionSet set);

}  // namespace springcheck::dynamics
