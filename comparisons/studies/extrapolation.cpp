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

Extrapolated extrapolate(const GridSizes& sizes, const OnThreeGrids& values,
                         double noise) {
  const auto& [q1, q2, q3] = values;
  const Eigen::MatrixXd coarse = q1 - q2, fine = q2 - q3;
  const double coarse_change = root_mean_square(coarse);
  const double fine_change = root_mean_square(fine);
  Extrapolated limit{.value = q3, .bar = fine};
  if (coarse_change <= noise && fine_change <= noise) {
    limit.bar.setZero();
  } else {
    const double sign = coarse.cwiseProduct(fine).sum() < 0 ? -1 : 1;
    limit.order = observed_order(sizes, sign * coarse_change, fine_change);
    if (limit.order) {
      const double rest = 1 / (std::pow(sizes[1] / sizes[2], *limit.order) - 1);
      limit.value -= rest * fine;
      limit.bar *= safety_with_order * rest;
    } else {
      limit.bar *= safety_without_order;
    }
  }
  limit.bar = limit.bar.cwiseAbs().cwiseMax(noise);
  return limit;
}

}  // namespace springcheck
