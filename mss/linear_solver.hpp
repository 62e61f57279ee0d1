#pragma once

namespace springcheck::mss {

/// How find_equilibrium solves with the tangent. By size: directly up to a number of
/// unknowns, iteratively above.
enum class LinearSolver { by_size, direct, iterative };

}  // namespace springcheck::mss
