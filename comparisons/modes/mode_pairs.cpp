#include "comparisons/modes/mode_pairs.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <functional>

namespace springcheck {
namespace {

using Eigen::Index, Eigen::MatrixXd;

MatrixXd orthonormal_shapes(const NaturalModes& modes, const Multiplet& multiplet) {
  const MatrixXd shapes = modes.shapes.middleCols(multiplet.first, multiplet.count);
  return Eigen::HouseholderQR<MatrixXd>(shapes).householderQ() *
         MatrixXd::Identity(shapes.rows(), shapes.cols());
}

/// A direction in the space of one of the others' multiplets.
struct Candidate {
  std::size_t group;
  double mac;
};

}  // namespace

std::vector<Multiplet> multiplets(const NaturalModes& modes) {
  constexpr double equal = 1e-6;  // of a frequency: far above rounding, far below gaps
  std::vector<Multiplet> groups;
  const Eigen::VectorXd& f = modes.frequencies;
  for (Index i = 0; i < f.size(); ++i)
    if (i > 0 && f[i] - f[i - 1] <= equal * f[i])
      ++groups.back().count;
    else
      groups.push_back({.first = i, .count = 1});
  return groups;
}

std::vector<Counterpart> counterparts(const NaturalModes& modes,
                                      std::span<const Multiplet> multiplets,
                                      const NaturalModes& others) {
  const std::vector<Multiplet> groups = springcheck::multiplets(others);
  std::vector<MatrixXd> bases;
  std::vector<Index> left;  // of each group, modes that are not taken yet
  for (const Multiplet& group : groups) {
    bases.push_back(orthonormal_shapes(others, group));
    left.push_back(group.count);
  }
  std::vector<Counterpart> found;
  for (const Multiplet& multiplet : multiplets) {
    const MatrixXd own = orthonormal_shapes(modes, multiplet);
    std::vector<Candidate> candidates;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const Eigen::VectorXd cosines =
          Eigen::JacobiSVD<MatrixXd>(own.transpose() * bases[g]).singularValues();
      for (Index i = 0; i < std::min(left[g], cosines.size()); ++i)
        candidates.push_back({.group = g, .mac = cosines[i] * cosines[i]});
    }
    std::ranges::stable_sort(candidates, std::greater{}, &Candidate::mac);
    candidates.resize(static_cast<std::size_t>(multiplet.count));
    double sum = 0;
    for (const Candidate& taken : candidates) {
      sum += others.frequencies[groups[taken.group].first];
      --left[taken.group];
    }
    found.push_back({.frequency = sum / static_cast<double>(multiplet.count),
                     .mac = candidates.back().mac});
  }
  return found;
}

std::vector<double> strangers(const NaturalModes& modes, const NaturalModes& others,
                              double highest) {
  const MatrixXd known =
      orthonormal_shapes(modes, {.first = 0, .count = modes.shapes.cols()});
  std::vector<double> found;
  for (Index i = 0; i < others.shapes.cols(); ++i) {
    const auto shape = others.shapes.col(i);
    const double part = (known.transpose() * shape).squaredNorm() / shape.squaredNorm();
    if (others.frequencies[i] <= highest && part < 0.5)
      found.push_back(others.frequencies[i]);
  }
  return found;
}

}  // namespace springcheck
