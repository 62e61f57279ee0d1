#pragma once

#include <filesystem>

#include "comparisons/tables/computed_tables.hpp"

namespace springcheck {

/// Writes NAME.md .csv .json .tex of every table and sheet of the set into the folder,
/// and removes those of tables that are not in it. Of caseless_sheet_names(), which no
/// result file gives back, the folder gets those of `earlier`, a folder that may be the
/// same or missing.
void write_tables(const std::filesystem::path& folder, const TableSet& set,
                  const std::filesystem::path& earlier);

}  // namespace springcheck
