#include "comparisons/mode_pairs.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <ranges>

namespace springcheck {
namespace {

using Eigen::Index, Eigen::MatrixXd;

/// MAC of every other shape.
Eigen::VectorXd likeness(const MatrixXd& shapes, const MatrixXd& others) {
  const Eigen::HouseholderQR<MatrixXd> factors(shapes);
  const MatrixXd basis =
      factors.householderQ() * MatrixXd::Identity(shapes.rows(), shapes.cols());
  return (basis.transpose() * others)
      .colwise()
      .squaredNorm()
      .cwiseQuotient(others.colwise().squaredNorm());
}

}  // namespace

std::vector<Multiplet> multiplets(const NaturalModes& modes, int up_to) {
  constexpr double equal = 1e-6;  // of a frequency: far above rounding, far below gaps
  std::vector<Multiplet> groups;
  const Eigen::VectorXd& f = modes.frequencies;
  for (Index i = 0; i < f.size(); ++i)
    if (i > 0 && f[i] - f[i - 1] <= equal * f[i])
      ++groups.back().count;
    else if (i < up_to)
      groups.push_back({.first = i, .count = 1});
    else
      break;
  return groups;
}

std::vector<Counterpart> counterparts(const NaturalModes& modes,
                                      const std::vector<Multiplet>& multiplets,
                                      const NaturalModes& others) {
  std::vector<Counterpart> found;
  std::vector<Index> left;  // others that are not taken yet
  for (Index i = 0; i < others.frequencies.size(); ++i) left.push_back(i);
  for (const auto& [first, count] : multiplets) {
    const Eigen::VectorXd mac =
        likeness(modes.shapes.middleCols(first, count), others.shapes);
    std::ranges::stable_sort(left, std::ranges::greater{},
                             [&](Index i) { return mac[i]; });
    const auto taken = left | std::views::take(count);
    const auto frequency = [&](Index i) { return others.frequencies[i]; };
    const auto [low, high] =
        std::ranges::minmax(taken | std::views::transform(frequency));
    double sum = 0;
    for (const Index i : taken) sum += frequency(i);
    found.push_back({.frequency = sum / static_cast<double>(count),
                     .spread = high - low,
                     .mac = mac[taken.back()]});
    left.erase(left.begin(), left.begin() + count);
  }
  return found;
}

}  // namespace springcheck
