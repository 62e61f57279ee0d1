#pragma once

#include <vector>

#include "comparisons/chart/chart.hpp"
#include "comparisons/formats/table.hpp"

namespace springcheck {

/// "chart-converged": what each law converges to, and what that may be off.
Table truths_table(const std::vector<Chart>& charts);

/// "chart": every point with its times, counts, and errors against the law of its scene.
Table points_table(const std::vector<Chart>& charts);

/// "chart-laws": errors of every case against the truth of each law.
Table laws_table(const std::vector<Chart>& charts);

/// "chart-front": the fronts, of each scene, kind, law and measure.
Table front_table(const std::vector<Chart>& charts);

/// Names of the tables of charts, claims included.
const std::vector<std::string>& chart_table_names();

/// All of them; none without charts.
std::vector<Table> chart_tables(const std::vector<Chart>& charts);

}  // namespace springcheck
