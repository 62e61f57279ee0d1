#pragma once

#include <cstddef>

#include "fem_reference/laws/settings.hpp"

namespace springcheck::fem_reference {

/// What a body of so many displacement components, prescribed ones included, is solved
/// by: multigrid where that is cheaper than a factor.
///
/// Measured on cubes, one solution of Hooke's law, direct / multigrid [s]: q1_sri at
/// 10^3, 20^3, 30^3 cells and nu = .25 0.1/0.4, 2.2/1.0, 13/3.7; nu = .499
/// 0.1/0.7, 2.2/2.7; q2 at 10^3 cells 2.3/3.1 and 2.3/20. A factor also needs two to
/// three times the memory.
statics::LinearSolver linear_solver_taken(const Settings& settings, double poisson_ratio,
                                          std::size_t components);

}  // namespace springcheck::fem_reference
