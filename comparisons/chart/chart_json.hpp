#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "comparisons/chart/chart.hpp"

namespace springcheck {

/// The charts of a result file with their errors, by scene. Throws like read_results.
std::vector<Chart> stored_charts(const std::filesystem::path& file, Revisions revisions);

/// Charts for figures, a list of:
///
///     scene, law (of the scene's own reference), answer (a measure), machine, quick
///              (whether all models are foremost ones, see ChartModels)
///     truths   law; of answer and volume_change (of V0) value, bar, order; bars: of
///              force, volume, deviation, as fractions
///     points   model, kind, across, cells, threads, status (why, where not
///              run), case, times (lower_quartile, median, upper_quartile, fastest_round,
///              slowest_round; seconds, or real per simulated), rounds and setup; null
///              where unknown; errors: by law, of each measure
///     fronts   kind, law, measure, points (places), errors_told: of each its error, or
///              what the truth may be off on its mesh where that is more
///     claims   kind, measure, springs (model), faster, as_accurate,
///     faster_at_equal_accuracy, words
nlohmann::ordered_json charts_json(const std::vector<Chart>& charts);

}  // namespace springcheck
