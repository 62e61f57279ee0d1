#pragma once

#include <filesystem>

#include "comparisons/results/result_file.hpp"
#include "comparisons/tables/computed_tables.hpp"

namespace springcheck {

/// What a result file can fill without a simulation: of the thesis's tables the rows
/// whose case is there, with a note where others are lacking, and no reference value
/// where that case is; of the sheets those that lack no case (5.5 beside tables of the
/// thesis only), but not caseless_sheet_names(), which have to be computed; and
/// cases_sheet. Each says which cases of other revisions it is made of; a row's reference
/// is of its own revision, and so are all cases of a sheet, or there is none. Throws like
/// read_results.
TableSet stored_tables(const std::filesystem::path& file, MeshStore& meshes,
                       Revisions revisions);

}  // namespace springcheck
