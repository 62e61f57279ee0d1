#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comparisons/studies/study.hpp"
#include "comparisons/tables/catalogue.hpp"

namespace springcheck {

struct ComputedTables {
  std::vector<Table> tables;
  std::vector<CaseResult> results;  // of every request behind them
};

/// What those tables need, without their references where they have the usual ones.
std::vector<Request> requests_behind(std::span<const CatalogueEntry* const> entries);

/// Computes the tables with everything they need, each simulation once, `parallel` of
/// them at a time; see run_study for `known`, of which only cases with their fields are
/// taken where one of the tables needs fields. `computed` is called with each result that
/// was not known, one at a time. Known results of other revisions are taken where a row
/// and its reference, or all that a table without such rows is made of, are of one.
/// Throws InputError like plan_of.
ComputedTables compute_tables(std::span<const CatalogueEntry* const> entries,
                              const std::optional<ReferenceMethod>& reference,
                              MeshStore& meshes, int parallel,
                              const KnownResult& known = {},
                              const std::function<void(const CaseResult&)>& computed = {},
                              Revisions revisions = Revisions::own);

}  // namespace springcheck
