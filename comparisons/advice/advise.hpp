#pragma once

#include "comparisons/advice/advice.hpp"
#include "comparisons/advice/measurements.hpp"
#include "comparisons/advice/soundness.hpp"
#include "comparisons/advice/wish.hpp"
#include "comparisons/chart/chart_plan.hpp"

namespace springcheck {

/// The cheapest model that meets the wish for a reason (Examiner): every model is run on
/// finer and finer cells until it does, its error no longer falls, it fails, or it would
/// cost more than twice what has met it, or more than the wish's budget, by the growth of
/// its times. Models that have one Poisson's ratio, and not the scene's, are no
/// candidates.
///
/// Where the truth's error bound decides of a point that would be the cheapest, the truth
/// is refined, once; where the error bound alone exceeds the tolerance then, the search
/// ends.
///
/// Of points than which the cheapest one is not faster, as far as times can tell, it is
/// the one that takes the least memory, then the first in chart_models, which go from
/// plain to rich.
Advice advise(const Wish& wish, const ChartPlan& plan, Measurements& measurements);

}  // namespace springcheck
