#pragma once

#include <cstddef>

namespace springcheck::statics {

/// How linear systems are solved: by a Cholesky factor, or by conjugate gradients, with
/// the nodes' 3x3 blocks for a preconditioner or with algebraic multigrid. `automatic` is
/// taken by size.
enum class LinearSolver { automatic, direct, conjugate_gradients, multigrid };

/// What a body of so many unknowns is solved by, springs and elements alike: the solver
/// that is wanted, or by size.
LinearSolver linear_solver_taken(LinearSolver wanted, std::ptrdiff_t unknowns);

}  // namespace springcheck::statics
