#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "comparisons/results/case_rows.hpp"
#include "comparisons/results/stored_chart.hpp"
#include "comparisons/studies/checked_number.hpp"
#include "comparisons/studies/study.hpp"

namespace springcheck {

/// The measures that have errors, each of which is a fraction:
///
///     force      |a - a*|/|a*|          a: plate force, torque, or drop of the tip
///     volume     |V - V*|/(V0 e)        e = u/H, the strain that is imposed
///     deviation  volume-weighted root mean square over the free nodes of |x - x*|/u
///
/// with * for the truth, u the largest displacement that is imposed (bending: the truth's
/// drop of the tip) and H the height. The error of the volume is over the strain because
/// V* may be V0. Nodes that are held tell nothing of a model: a body without free ones
/// has no deviation.
enum class ChartMeasure { force, volume, deviation };

template <>
inline constexpr std::array value_names<ChartMeasure>{
    Named{ChartMeasure::force, "force"}, Named{ChartMeasure::volume, "volume"},
    Named{ChartMeasure::deviation, "deviation"}};

/// An error, or what the truth itself may be off, of each measure; none where it is not
/// known.
struct ChartErrors {
  std::optional<double> force{}, volume{}, deviation{};

  [[nodiscard]] const std::optional<double>& of(ChartMeasure measure) const;
};

/// What a law converges to.
struct ChartTruth {
  StoredChart::Truth grids;
  CheckedNumber answer;         // [N], [N m] or [m]
  CheckedNumber volume_change;  // of V0
  double imposed;               // u [m]
  ChartErrors error_bounds{};   // deviation's: the largest of any mesh compared
};

/// The element of the grids that a number is told by.
std::string_view element_of(const CheckedNumber& number);

/// The truth by the figures of its cases; none where a grid of q2 failed. Where a grid
/// that checks it failed, it is not checked.
std::optional<ChartTruth> truth_of(const StoredChart& chart,
                                   const StoredChart::Truth& grids,
                                   const std::map<std::string, StoredCase>& cases);

/// How far the limits of two fields are apart, as deviation_l2_relative over the nodes of
/// the first's coarsest grid, and where they are farther apart than the error bounds of
/// both, the other's error bound with it. Both have three results, with fields; none
/// where one failed, or where all nodes are held.
std::optional<double> apart_in_places(std::span<const CaseResult* const> grids,
                                      std::span<const CaseResult* const> check,
                                      MeshStore& meshes);

}  // namespace springcheck
