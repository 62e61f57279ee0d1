#pragma once

#include "dynamics/marching/march.hpp"
#include "meshing/basics/stopwatch.hpp"
#include "mss/tissue/tissue_motion.hpp"

namespace springcheck::mss {

/// Why tissue does not move so, or nothing when it does: it steps explicitly, and keeps
/// no checkpoints, which would have to hold its memories.
std::optional<std::string> reason_to_refuse_tissue(const dynamics::Protocol& protocol,
                                                   const dynamics::Observers& observers);

/// Moves tissue through time by the explicit integrators, see TissueMotion and
/// dynamics::march; the stability limit is that of the memories as they are, beside which
/// they can only give way. The solution's largest_shear_strain is of the moments at which
/// march looks at that limit, the ends of the load's pieces among them.
Solution run_tissue_dynamics(const Mesh& mesh, const Scene& scene, const TissueBody& body,
                             const dynamics::Protocol& protocol, int threads = 1,
                             const dynamics::Observers& observers = {},
                             const Stopwatch& setup = {});

}  // namespace springcheck::mss
