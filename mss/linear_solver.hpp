#pragma once

namespace springcheck::mss {

/// How find_equilibrium solves with the tangent: by its Cholesky factor, or by conjugate
/// gradients on its 3x3 blocks. By size: directly up to 10,000 unknowns.
///
/// Measured on the compression of cubes of mss-cf, whole solutions on one core, in
/// seconds at nu = .25 and .499:
///
///     cells   direct        iterative
///     10^3    .2    .4      .03   .2
///     20^3    3.7   5.4     .3    1.7
///     60^3    no memory     20    150
enum class LinearSolver { by_size, direct, iterative };

}  // namespace springcheck::mss
