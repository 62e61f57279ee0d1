#pragma once

#include "mss/networks/network.hpp"

namespace springcheck::mss {

/// The last state of the path from rest that is stable and turns no cell inside out, with
/// the load fraction found to .2 % (follow_to_limit). Status ok at the full load; before
/// it indefinite where the path goes on without stability, no_equilibrium at a limit
/// point, inverted, or not_converged where the solver fails; but for that with
/// definite_up_to, and critical_wavelength.
Solution path_limit_solution(const Mesh& mesh, const Scene& scene,
                             const Network& network);

}  // namespace springcheck::mss
