#include "comparisons/studies/converged_number.hpp"

#include <cmath>

#include "comparisons/studies/formal_order.hpp"

namespace springcheck {

ConvergedNumber converged_number(const GridSizes& sizes,
                                 const std::array<double, 3>& values, double noise,
                                 double formal_order) {
  OnThreeGrids on_grids;
  for (std::size_t i = 0; i < 3; ++i)
    on_grids[i] = Eigen::MatrixXd::Constant(1, 1, values[i]);
  const Extrapolated limit = extrapolate(sizes, on_grids, noise, formal_order);
  return {.value = limit.value(0), .order = limit.order, .bar = limit.bar(0)};
}

ConvergedNumber converged_number(const ThreeCases& cases,
                                 const std::array<double, 3>& values, double noise) {
  return converged_number(grid_sizes(cases), values, noise, formal_order(cases[0]));
}

ConvergedNumber converged_number(const ThreeCases& cases,
                                 const std::array<double, 3>& values) {
  return converged_number(cases, values, solver_noise * std::abs(values[2]));
}

}  // namespace springcheck
