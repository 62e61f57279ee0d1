#pragma once

#include <span>

#include "mss/networks/network.hpp"

namespace springcheck::mss {

/// The Solution of an equilibrium at a load fraction: displacements, reactions of the
/// supports and energy; status ok.
Solution static_solution(const Mesh& mesh, const Scene& scene, const Network& network,
                         std::span<const Vector3> positions, double load_fraction);

}  // namespace springcheck::mss
