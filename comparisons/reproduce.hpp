#pragma once

#include <filesystem>
#include <functional>
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
/// `parallel` of them at a time; see run_study for `known`, of which sheets take only
/// cases with their fields. `computed` is called with each result that was not known, one
/// at a time. Throws InputError for a sheet with a reference: sheets have theirs.
ComputedTables compute_tables(
    const std::vector<std::string>& names,
    const std::optional<ReferenceMethod>& reference, MeshStore& meshes, int parallel,
    const KnownResult& known = {},
    const std::function<void(const CaseResult&)>& computed = {});

/// Whether the tables that take many minutes (long_sheet_names) are among the tables.
enum class Extent { without_long_tables, all };

/// Regenerates every table into `directory`, created if need be:
///
///     summary.md          what was computed, what agrees with the thesis, what fails
///     tables/NAME.md .csv .json
///     results.h5 .xdmf    every case with its fields, settings and provenance
///
/// Cases go into results.h5 as they come; those that are there already are taken, if this
/// very program computed them, so that an interrupted run goes on where it was.
/// Throws InputError before computing when the directory cannot be written.
void reproduce(const std::filesystem::path& directory, Extent extent, int parallel);

}  // namespace springcheck
