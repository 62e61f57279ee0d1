#pragma once

#include <filesystem>
#include <vector>

#include "comparisons/formats/table.hpp"
#include "comparisons/results/result_file.hpp"

namespace springcheck {

/// What a result file can fill without a simulation: of tables whose rows stand by
/// themselves the rows whose case is there, with a note where others are lacking, and no
/// reference value where that case is; of other tables those that lack no case, and those
/// that are counted beside tables of printed figures; and all_cases_table. Each says
/// which cases of other revisions it is made of; a row's reference is of its own
/// revision, and so are all cases of another table, or there is none. Throws like
/// read_results.
std::vector<Table> stored_tables(const std::filesystem::path& file, MeshStore& meshes,
                                 Revisions revisions);

}  // namespace springcheck
