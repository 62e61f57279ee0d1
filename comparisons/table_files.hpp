#pragma once

#include <filesystem>

#include "comparisons/computed_tables.hpp"

namespace springcheck {

/// Writes NAME.md .csv .json .tex of every table and sheet of the set into the folder,
/// and removes those of tables that are not in it.
void write_tables(const std::filesystem::path& folder, const TableSet& set);

}  // namespace springcheck
