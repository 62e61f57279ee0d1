#pragma once

#include "comparisons/chart/advice.hpp"
#include "comparisons/chart/chart_plan.hpp"
#include "comparisons/chart/measurements.hpp"
#include "comparisons/chart/wish.hpp"

namespace springcheck {

/// The cheapest model that meets the wish: every model is run on finer and finer cells
/// until it meets the tolerance, its error no longer falls, it fails, or it would cost
/// more than twice what has met it, or more than the wish's budget, by the growth of its
/// times.
///
/// A point counts where its model, if the budget allows it, meets the tolerance on the
/// next finer cells too, the truth's bar apart: else its error was small because others
/// cancelled in it, and it is taken, with a caution, only where no other is. Springs
/// count only where the static path to the full load stays stable (solver limit), or
/// where following it would take more than the budget by that on coarser cells; states
/// that a detector calls wrinkled, inverted or indefinite never do.
///
/// Of points than which the cheapest one is not faster, as far as times can tell, it is
/// the one that takes the least memory, then the first in chart_models, which go from
/// plain to rich.
///
/// Throws std::runtime_error where the scene's law has no truth.
Advice advise(const Wish& wish, const ChartPlan& plan, Measurements& measurements);

}  // namespace springcheck
