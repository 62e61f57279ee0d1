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

/// The neighbour in words: "at 0.8 times the load", "at nu = 0.35".
std::string name_of(const Neighbour& neighbour);

/// The scenes at .8 and 1.2 times the load, then those with a Poisson's ratio .02 lower
/// and .02 higher, but at most half way to 1/2.
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
/// so that only that part of the grid's own error is left which changes with the scene.
/// Its error bounds are those of the scene, plus the difference from what the coarser
/// grid gives in the same way. `imposed` is u' in the neighbour; none where it is the
/// answer. `deviation` is what the second grid is off in deviation.
ChartTruth carried_truth(const ChartTruth& truth, const StoredChart& chart,
                         const TwoGrids& here, const TwoGrids& there,
                         const std::optional<double>& imposed,
                         const std::optional<double>& deviation);

/// The errors less what the truth may be off; none is below 0.
ChartErrors beyond_error_bounds(const ChartErrors& errors,
                                const ChartErrors& error_bounds);

}  // namespace springcheck
