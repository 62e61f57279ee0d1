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

}  // namespace springcheck
