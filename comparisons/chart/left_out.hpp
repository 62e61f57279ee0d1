#pragma once

#include <string>
#include <vector>

#include "comparisons/chart/advice.hpp"
#include "comparisons/chart/chart_plan.hpp"

namespace springcheck {

/// What the chosen model does without that others of the chart have: corrections, face
/// diagonals, nonlinear strains, other laws, elements, cells, precision and finer meshes,
/// each with the figures of the measured alternative on the same cells, or on those
/// nearest to them.
std::vector<std::string> left_out(const Advice& advice, ChartMeasure measure,
                                  const ChartPlan& plan);

}  // namespace springcheck
