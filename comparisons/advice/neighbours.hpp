#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/cases/case.hpp"
#include "comparisons/chart/chart.hpp"

namespace springcheck {

/// A scene beside another, by its load or by its Poisson's ratio.
struct Neighbour {
  double load = 1;       // that of the scene times this: strain, angle or weight
  double poisson_ratio;  // the scene's own, or another
};

/// "at 0.8 times the load", "at nu = 0.35".
std::string name_of(const Neighbour& neighbour);

/// At .8 and 1.2 times the load, and .02 below and above in Poisson's ratio, but half way
/// to 1/2 at most; those by their load first.
std::vector<Neighbour> neighbours_of(const CaseSettings& settings);

/// The case in a scene beside its own; none where its test has no such load.
std::optional<CaseSettings> moved(CaseSettings settings, const Neighbour& neighbour);

/// What q2 shows on the two coarser grids of a truth, from coarse to fine.
using TwoGrids = std::array<Measures, 2>;

/// The truth a* and V* of a neighbour from that of the scene and what q2 shows on the
/// second grid in both (a and V in the scene, a' and V' in the neighbour):
///
///     a'* = a' a*/a,   V'* = V' + (V* - V) u'/u
///
/// so that of the grid's own error only what changes with the scene is left. Its error
/// bounds are those of the scene and what the same by the coarser grid differs by.
/// `imposed`: u' in the neighbour; none where it is the answer. `deviation` is what the
/// second grid is off in that.
ChartTruth carried_truth(const ChartTruth& truth, const StoredChart& chart,
                         const TwoGrids& here, const TwoGrids& there,
                         const std::optional<double>& imposed,
                         const std::optional<double>& deviation);

/// Errors without what the truth may be off; none below 0.
ChartErrors beyond_error_bounds(const ChartErrors& errors,
                                const ChartErrors& error_bounds);

}  // namespace springcheck
