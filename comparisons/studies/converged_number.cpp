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
  return {
      .value = limit.value(0), .order = limit.order, .error_bound = limit.error_bound(0)};
}

ConvergedNumber converged_number(const ThreeCases& cases,
                                 const std::array<double, 3>& values, double noise) {
  return converged_number(grid_sizes(cases), values, noise, formal_order(cases[0]));
}

ConvergedNumber converged_difference(const ThreeCases& cases,
                                     const std::array<double, 3>& differences,
                                     double noise) {
  const GridSizes sizes = grid_sizes(cases);
  const auto [h1, h2, h3] = sizes;
  const auto [q1, q2, q3] = differences;
  const double coarse_change = q1 - q2, fine_change = q2 - q3;
  if (std::max(std::abs(coarse_change), std::abs(fine_change)) <= noise)
    return {.value = q3, .order = std::nullopt, .error_bound = noise};
  const BelievedOrder believed =
      believed_order(sizes, coarse_change, fine_change, formal_order(cases[0]));
  const double p = believed.order, rest = fine_change * rest_by_order(h2 / h3, p);
  const double left =
      std::max(std::abs(rest), std::abs(coarse_change) * rest_by_order(h1 / h2, p) *
                                   std::pow(h3 / h2, p));
  if (!believed.is_monotone)
    return {.value = q3,
            .order = believed.observed,
            .error_bound = std::max(cautious_safety * left, noise)};
  return {.value = q3 - rest,
          .order = believed.observed,
          .error_bound = std::max((cautious_safety + 1) * left, noise)};
}

ConvergedNumber converged_number(const ThreeCases& cases,
                                 const std::array<double, 3>& values) {
  return converged_number(cases, values, solver_noise * std::abs(values[2]));
}

}  // namespace springcheck
