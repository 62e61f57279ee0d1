#pragma once

namespace springcheck::statics {

/// How linear systems are solved: by a Cholesky factor, or by conjugate gradients, with
/// the nodes' 3x3 blocks for a preconditioner or with algebraic multigrid. `automatic` is
/// a choice by size.
enum class LinearSolver { automatic, direct, conjugate_gradients, multigrid };

}  // namespace springcheck::statics
