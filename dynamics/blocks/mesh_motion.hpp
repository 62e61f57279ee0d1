#pragma once

#include <memory>
#include <span>
#include <vector>

#include "dynamics/blocks/explicit_motion.hpp"
#include "meshing/loads/scene.hpp"

namespace springcheck::dynamics {

/// Explicit steps of a mesh in a scene: explicit_motion from rest, with the scene's
/// supports and its loads on the nodes' masses [kg] (load_forces). The blocks hold every
/// node.
template <class Real>
std::unique_ptr<Motion> mesh_motion(const Mesh& mesh, const Scene& scene,
                                    std::span<const double> masses,
                                    std::vector<Block> blocks, BlockForces<Real> forces,
                                    const ExplicitSettings& settings);

/// The same of the mesh as a single block, on one thread, with forces that need no
/// kernel.
std::unique_ptr<Motion> plain_motion(const Mesh& mesh, const Scene& scene,
                                     std::span<const double> masses, ForcesAt forces,
                                     Integrator integrator, InstructionSet set);

}  // namespace springcheck::dynamics
