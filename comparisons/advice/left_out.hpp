#pragma once

#include <string>
#include <vector>

#include "comparisons/advice/advice.hpp"
#include "comparisons/chart/chart_plan.hpp"

namespace springcheck {

/// What the chosen model does without that others of the chart have: corrections, face
/// diagonals, nonlinear strains, other laws, elements, cells, precision and finer meshes,
/// each with the figures (the largest error of those measures) of the measured
/// alternative on the same cells, or on those nearest to them.
std::vector<std::string> left_out(const Advice& advice,
                                  const std::vector<ChartMeasure>& measures,
                                  const ChartPlan& plan);

}  // namespace springcheck
