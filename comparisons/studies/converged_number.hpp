#pragma once

#include <array>

#include "comparisons/studies/converged.hpp"

namespace springcheck {

/// What one number of a case converges to on three grids, with its order and bar.
struct ConvergedNumber {
  double value;
  std::optional<double> order;
  double bar;
};

/// Extrapolates `values` on three grids, from coarse to fine; changes of at most `noise`
/// are the solvers'.
ConvergedNumber converged_number(const GridSizes& sizes,
                                 const std::array<double, 3>& values, double noise);

/// The same on the grids of three cases.
ConvergedNumber converged_number(const ThreeCases& cases,
                                 const std::array<double, 3>& values, double noise);

/// The same with solver_noise of the finest value.
ConvergedNumber converged_number(const ThreeCases& cases,
                                 const std::array<double, 3>& values);

/// What a limit of three grids h, h/2 and h/4 may be off, by the limit of 2h, h and h/2
/// beside it: limits that get nearer at first order at least are off by no more than the
/// last change between them. 1.25 times that change, but no more than the limit's own
/// bar; that bar where one of the two has no order.
double bar_by_fourth_grid(const ConvergedNumber& coarser, const ConvergedNumber& limit);

}  // namespace springcheck
