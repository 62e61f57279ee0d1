#pragma once

#include <filesystem>
#include <span>

#include "comparisons/formats/table.hpp"

namespace springcheck {

/// Writes NAME.md .csv .json .tex of every table into the folder, and removes those of
/// tables that are not among them. Of tables that are computed when they are printed,
/// which no result file gives back, the folder gets those of `earlier`, a folder that may
/// be the same or missing.
void write_tables(const std::filesystem::path& folder, std::span<const Table> tables,
                  const std::filesystem::path& earlier);

}  // namespace springcheck
