#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/sheet.hpp"
#include "comparisons/tables.hpp"

namespace springcheck {

struct ComputedTables {
  std::vector<Table> tables;        // of table_names()
  std::vector<Sheet> sheets;        // of sheet_names()
  std::vector<CaseResult> results;  // of every request behind them
};

/// Computes the named tables and sheets with everything they need, each simulation once,
/// `parallel` of them at a time; see run_study for `known`. Throws InputError for a sheet
/// with a reference: sheets have theirs.
ComputedTables compute_tables(const std::vector<std::string>& names,
                              const std::optional<ReferenceMethod>& reference,
                              MeshStore& meshes, int parallel,
                              const KnownResult& known = {});

/// Whether the split table, which takes minutes, is among the tables.
enum class Extent { without_split, all };

/// Regenerates every table into `directory`, created if need be:
///
///     summary.md          what was computed, what agrees with the thesis, what fails
///     tables/NAME.md .csv .json
///     results.h5 .xdmf    every case with its fields, settings and provenance
///
/// Throws InputError before computing when the directory cannot be written.
void reproduce(const std::filesystem::path& directory, Extent extent, int parallel);

}  // namespace springcheck
