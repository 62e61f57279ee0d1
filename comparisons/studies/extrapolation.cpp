#include "comparisons/studies/extrapolation.hpp"

#include <cassert>
#include <cmath>

namespace springcheck {
namespace {

/// (h1^p - h2^p)/(h2^p - h3^p); grows with p.
double ratio_of_changes(const GridSizes& h, double p) {
  return (std::pow(h[0] / h[1], p) - 1) / (1 - std::pow(h[2] / h[1], p));
}

double root_mean_square(const Eigen::MatrixXd& values) {
  return values.norm() / std::sqrt(static_cast<double>(values.size()));
}

}  // namespace

std::optional<double> observed_order(const GridSizes& sizes, double coarse_change,
                                     double fine_change) {
  assert(sizes[0] > sizes[1] && sizes[1] > sizes[2] && sizes[2] > 0);
  const double ratio = coarse_change / fine_change;
  double low = lowest_order, high = highest_order;
  const bool is_bracketed =
      ratio >= ratio_of_changes(sizes, low) && ratio <= ratio_of_changes(sizes, high);
  if (!is_bracketed) return std::nullopt;
  while (true) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) return middle;
    (ratio_of_changes(sizes, middle) < ratio ? low : high) = middle;
  }
}

std::optional<double> fitted_order(std::span<const double> sizes,
                                   std::span<const double> errors) {
  const auto count = static_cast<Eigen::Index>(sizes.size());
  const Eigen::ArrayXd e = Eigen::Map<const Eigen::ArrayXd>(errors.data(), count);
  if (!(e > 0).all()) return std::nullopt;
  const Eigen::ArrayXd x = Eigen::Map<const Eigen::ArrayXd>(sizes.data(), count).log();
  const Eigen::ArrayXd from_mean = x - x.mean();
  return (from_mean * e.log()).sum() / from_mean.square().sum();
}

BelievedOrder believed_order(const GridSizes& sizes, double coarse_change,
                             double fine_change, double formal_order) {
  constexpr double near_formal = 0.1, lowest_believed = 0.5;
  const auto observed = observed_order(sizes, coarse_change, fine_change);
  if (observed && std::abs(*observed - formal_order) <= near_formal * formal_order)
    return {observed, formal_order, asymptotic_safety, true};
  if (observed)
    return {observed, std::min(std::max(*observed, lowest_believed), formal_order),
            cautious_safety, true};
  // Changes that cease fall faster than any, of whatever sign.
  const double ratio = coarse_change * fine_change < 0
                           ? coarse_change / fine_change
                           : std::abs(coarse_change) / std::abs(fine_change);
  const double ratio_of_order_0 =
      std::log(sizes[0] / sizes[1]) / std::log(sizes[1] / sizes[2]);
  const bool falls_faster = ratio > ratio_of_changes(sizes, highest_order);
  return {std::nullopt, falls_faster ? formal_order : lowest_believed, cautious_safety,
          ratio > ratio_of_order_0};
}

double rest_by_order(double ratio, double order) {
  return 1 / (std::pow(ratio, order) - 1);
}

Extrapolated extrapolate(const GridSizes& sizes, const OnThreeGrids& values, double noise,
                         double formal_order) {
  const auto& [q1, q2, q3] = values;
  const Eigen::MatrixXd coarse = q1 - q2, fine = q2 - q3;
  const double coarse_change = root_mean_square(coarse);
  const double fine_change = root_mean_square(fine);
  Extrapolated limit{.value = q3, .error_bound = fine};
  if (coarse_change <= noise && fine_change <= noise) {
    limit.error_bound.setZero();
  } else {
    const double sign = coarse.cwiseProduct(fine).sum() < 0 ? -1 : 1;
    const BelievedOrder believed =
        believed_order(sizes, sign * coarse_change, fine_change, formal_order);
    const double rest = rest_by_order(sizes[1] / sizes[2], believed.order);
    limit.order = believed.observed;
    limit.index = believed.safety_factor * rest;

    limit.error_bound *= *limit.index;
    if (believed.is_monotone) {
      limit.value -= rest * fine;
      limit.error_bound += rest * fine;
    }
  }
  limit.error_bound = limit.error_bound.cwiseAbs().cwiseMax(noise);
  return limit;
}

}  // namespace springcheck
