#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comparisons/sheets/sheet.hpp"
#include "comparisons/studies/study.hpp"
#include "comparisons/tables/thesis/tables.hpp"

namespace springcheck {

struct TableSet {
  std::vector<Table> tables;  // of table_names()
  std::vector<Sheet> sheets;  // of sheet_names()
};

struct ComputedTables {
  TableSet set;
  std::vector<CaseResult> results;  // of every request behind them
};

/// What compute_tables needs for the named tables and sheets, without their references.
std::vector<Request> requests_behind(const std::vector<std::string>& names);

/// Computes the named tables and sheets with everything they need, each simulation once,
/// `parallel` of them at a time; see run_study for `known`, of which sheets take only
/// cases with their fields. `computed` is called with each result that was not known, one
/// at a time. Known results of other revisions are taken where a row and its
/// reference, or all that a sheet is made of, are of one. Throws InputError for a sheet
/// with a reference: sheets have theirs.
ComputedTables compute_tables(const std::vector<std::string>& names,
                              const std::optional<ReferenceMethod>& reference,
                              MeshStore& meshes, int parallel,
                              const KnownResult& known = {},
                              const std::function<void(const CaseResult&)>& computed = {},
                              Revisions revisions = Revisions::own);

}  // namespace springcheck
