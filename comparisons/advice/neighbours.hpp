#pragma once

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
/// to 1/2 at most; without those that the test does not have.
std::vector<Neighbour> neighbours_of(const CaseSettings& settings);

/// The case in a scene beside its own.
CaseSettings moved(CaseSettings settings, const Neighbour& neighbour);

/// The truth a* and V* of a neighbour from that of the scene and what q2 shows on one
/// grid in both (a and V without neighbour, a' and V' in it):
///
///     a'* = a' a*/a,   V'* = V' + (V* - V) u'/u
///
/// so that of the grid's own error only what changes with the scene is left. It is taken
/// to be off by as much as the scene's; `deviation` is what the grid is off in that.
ChartTruth carried_truth(const ChartTruth& truth, const std::string& answer,
                         const Measures& grid, const Measures& grid_there,
                         double imposed_there, std::optional<double> deviation);

/// Errors without what the truth may be off; none below 0.
ChartErrors beyond_bars(const ChartErrors& errors, const ChartErrors& bars);

}  // namespace springcheck
