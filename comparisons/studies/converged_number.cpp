#include "comparisons/studies/converged_number.hpp"

#include <algorithm>
#include <cmath>

namespace springcheck {

ConvergedNumber converged_number(const GridSizes& sizes,
                                 const std::array<double, 3>& values, double noise) {
  OnThreeGrids on_grids;
  for (std::size_t i = 0; i < 3; ++i)
    on_grids[i] = Eigen::MatrixXd::Constant(1, 1, values[i]);
  const Extrapolated limit = extrapolate(sizes, on_grids, noise);
  return {.value = limit.value(0), .order = limit.order, .bar = limit.bar(0)};
}

ConvergedNumber converged_number(const ThreeCases& cases,
                                 const std::array<double, 3>& values, double noise) {
  return converged_number(grid_sizes(cases), values, noise);
}

ConvergedNumber converged_number(const ThreeCases& cases,
                                 const std::array<double, 3>& values) {
  return converged_number(cases, values, solver_noise * std::abs(values[2]));
}

double bar_by_fourth_grid(const ConvergedNumber& coarser, const ConvergedNumber& limit) {
  if (!coarser.order || !limit.order) return limit.bar;
  return std::min(limit.bar, safety_with_order * std::abs(limit.value - coarser.value));
}

}  // namespace springcheck
