#pragma once

#include <vector>

#include "comparisons/chart/chart.hpp"
#include "comparisons/sheets/sheet.hpp"

namespace springcheck {

/// "chart-converged": what each law converges to, and what that may be off.
Sheet truths_sheet(const std::vector<Chart>& charts);

/// "chart": every point with its times, counts, and errors against the law of its scene.
Sheet points_sheet(const std::vector<Chart>& charts);

/// "chart-laws": errors of every case against the truth of each law.
Sheet laws_sheet(const std::vector<Chart>& charts);

/// "chart-front": the fronts, of each scene, kind, law and measure.
Sheet front_sheet(const std::vector<Chart>& charts);

/// Names of the sheets of charts, claims included.
const std::vector<std::string>& chart_sheet_names();

/// All of them; none without charts.
std::vector<Sheet> chart_sheets(const std::vector<Chart>& charts);

}  // namespace springcheck
