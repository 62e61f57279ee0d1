#pragma once

#include "mss/networks/network.hpp"
#include "statics/equilibrium.hpp"

namespace springcheck::mss {

/// The network's equilibrium under a scene's loads, by statics::find_equilibrium.
Solution find_equilibrium(const Mesh& mesh, const Scene& scene, const Network& network,
                          const statics::Search& search = {});

/// The like, by statics::last_stable_equilibrium.
Solution last_stable_equilibrium(const Mesh& mesh, const Scene& scene,
                                 const Network& network);

}  // namespace springcheck::mss
