#pragma once

namespace springcheck::mss {

/// How find_equilibrium solves with the tangent: by its Cholesky factor, or by conjugate
/// gradients on its 3x3 blocks. By size: directly up to 10,000 unknowns.
///
/// Measured: compression of cubes of mss-cf by 5 %, whole solutions, processor seconds
/// and gigabytes at nu = .25 and at .499:
///
///     cells   direct               iterative
///     10^3    .3   .4   (.1 GB)    .1   .3  (.1 GB)
///     30^3    19   31   (1.1 GB)   2.3  18  (.4 GB)
///     60^3                         35   287 (2.9 GB)
///
/// The direct ones with CHOLMOD's own teams of threads (see simulate), without which they
/// are shorter: not measured again at 30^3.
///
/// Of prototypes at 20^3 cells and nu = .499, without the test of definiteness: 1.5 s
/// like this, 3.2 with a two-level preconditioner, 3.9 with incomplete Cholesky, 4.2 by
/// dynamic relaxation, 5.5 by nonlinear conjugate gradients, 6.7 by L-BFGS. At nu = .25
/// all are within .2 and .6 s but incomplete Cholesky, 1.2.
enum class LinearSolver { by_size, direct, iterative };

}  // namespace springcheck::mss
