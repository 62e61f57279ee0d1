#pragma once

#include <array>

#include "comparisons/studies/converged.hpp"

namespace springcheck {

/// What one number of a case converges to on three grids, with its order and error bound.
struct ConvergedNumber {
  double value;
  std::optional<double> order;
  double error_bound;
};

/// Extrapolates `values` on three grids, from coarse to fine, as extrapolate does;
/// changes of at most `noise` are the solvers'.
ConvergedNumber converged_number(const GridSizes& sizes,
                                 const std::array<double, 3>& values, double noise,
                                 double formal_order);

/// The same on the grids of three cases, by their formal order.
ConvergedNumber converged_number(const ThreeCases& cases,
                                 const std::array<double, 3>& values, double noise);

/// What the difference of two numbers converges to, of the same cases on the same grids.
/// Its changes are differences too, which may cancel by chance: neither a small last
/// change nor an order near the formal one shows that it has converged. So the safety
/// factor is always 3, and the last change counts for no less than what the one before
/// it leaves:
///
///     q* = q3 + (q3 - q2)/((h2/h3)^p - 1),   bound = 4 e
///     q* = q3,                               bound = 3 e   (changes grow or turn back)
///     e = max(|q3 - q2|/((h2/h3)^p - 1), |q2 - q1| (h3/h2)^p/((h1/h2)^p - 1))
///
/// p is BelievedOrder's; changes of at most `noise` are the solvers', and no error bound
/// is smaller. Source: as believed_order; of chance our own. It is one part of what
/// bounds a law part (ErrorPart), which law_parts_test.cpp holds against finer grids; by
/// itself it misses 1 of 74 there.
ConvergedNumber converged_difference(const ThreeCases& cases,
                                     const std::array<double, 3>& differences,
                                     double noise);

/// The same as converged_number with solver_noise of the finest value.
ConvergedNumber converged_number(const ThreeCases& cases,
                                 const std::array<double, 3>& values);

}  // namespace springcheck
