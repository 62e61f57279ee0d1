#include "comparisons/studies/converged_number.hpp"

#include <algorithm>
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

ConvergedNumber converged_difference(const ThreeCases& cases,
                                     const std::array<double, 3>& differences,
                                     double noise) {
  ConvergedNumber limit = converged_number(cases, differences, noise);
  const auto [h1, h2, h3] = grid_sizes(cases);
  const auto [q1, q2, q3] = differences;
  if (std::max(std::abs(q1 - q2), std::abs(q2 - q3)) <= noise) return limit;
  const BelievedOrder believed =
      believed_order({h1, h2, h3}, q1 - q2, q2 - q3, formal_order(cases[0]));
  const double p = believed.order;
  const double left =
      std::max(std::abs(q2 - q3) * rest_by_order(h2 / h3, p),
               std::abs(q1 - q2) * rest_by_order(h1 / h2, p) * std::pow(h3 / h2, p));
  limit.bar = std::max((cautious_safety + (believed.is_monotone ? 1 : 0)) * left, noise);
  return limit;
}

ConvergedNumber converged_number(const ThreeCases& cases,
                                 const std::array<double, 3>& values) {
  return converged_number(cases, values, solver_noise * std::abs(values[2]));
}

}  // namespace springcheck
