#pragma once

#include <array>

#include "comparisons/studies/converged.hpp"

namespace springcheck {

/// What one number of a case converges to on three grids, with its order and bar.
struct ConvergedNumber {
  double value;
  std::optional<double> order;
  double bar;
  bool is_asymptotic = false;  // see Extrapolated
};

/// Extrapolates `values` on three grids, from coarse to fine, as extrapolate does;
/// changes of at most `noise` are the solvers'.
ConvergedNumber converged_number(const GridSizes& sizes,
                                 const std::array<double, 3>& values, double noise,
                                 double formal_order);

/// The same on the grids of three cases, by their formal order.
ConvergedNumber converged_number(const ThreeCases& cases,
                                 const std::array<double, 3>& values, double noise);

/// The same with solver_noise of the finest value.
ConvergedNumber converged_number(const ThreeCases& cases,
                                 const std::array<double, 3>& values);

/// What a limit of three grids h, h/2 and h/4 may be off, by the limit of 2h, h and h/2
/// beside it: limits that get nearer at first order at least are off by no more than the
/// last change between them. Three times that change where both show an order near the
/// formal one, but at least a ninth of the limit's own bar, which is a quarter of the
/// error that extrapolation took away: two limits may coincide. Else that bar, which is
/// the most. Measured on orders that are not: .013 % by limits of 1, 2, 4 and 2, 4, 8
/// cells of q2, 20 % compression at nu = .45, whose limit was .9 % off.
double bar_by_fourth_grid(const ConvergedNumber& coarser, const ConvergedNumber& limit);

}  // namespace springcheck
