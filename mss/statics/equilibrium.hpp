#pragma once

#include "meshing/basics/stopwatch.hpp"
#include "mss/networks/network.hpp"
#include "statics/equilibrium.hpp"

namespace springcheck::mss {

/// The network's equilibrium under a scene's loads, by statics::find_equilibrium, or
/// last_stable_equilibrium where the search is to the path's limit.
Solution find_equilibrium(const Mesh& mesh, const Scene& scene, const Network& network,
                          const statics::Search& search = {},
                          const Stopwatch& setup = {});

}  // namespace springcheck::mss
