#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/tables.hpp"

namespace springcheck {

struct ComputedTables {
  std::vector<Table> tables;
  std::vector<CaseResult> results;  // of every request behind them
};

/// Computes the named tables with everything they need, each simulation once, `parallel`
/// of them at a time; see run_study for `known`.
ComputedTables compute_tables(const std::vector<std::string>& names,
                              const std::optional<ReferenceMethod>& reference,
                              MeshStore& meshes, int parallel,
                              const KnownResult& known = {});

/// Regenerates every table into `directory`, created if need be:
///
///     summary.md          what was computed, what agrees with the thesis, what fails
///     tables/NAME.md .csv .json
///     results.h5 .xdmf    every case with its fields, settings and provenance
///
/// Throws InputError before computing when the directory cannot be written.
void reproduce(const std::filesystem::path& directory, int parallel);

}  // namespace springcheck
