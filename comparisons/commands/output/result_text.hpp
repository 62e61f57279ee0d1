#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/formats/table.hpp"
#include "comparisons/running/case_result.hpp"
#include "comparisons/studies/split.hpp"

namespace springcheck {

/// A row for each result, with a note on why it ended so; what else is to be known of
/// them, and of their reference, as notes of the table.
Table results_table(const std::string& scene, const std::vector<CaseResult>& results);

/// Prints the table as text for people, its notes below, or in a format; as JSON the
/// document of run_json().
void print_results(const std::string& scene, const std::vector<CaseResult>& results,
                   const std::vector<std::optional<Split>>& splits,
                   const std::optional<TableFormat>& format, MeshStore& meshes);

}  // namespace springcheck
