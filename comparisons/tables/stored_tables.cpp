#include "comparisons/tables/stored_tables.hpp"

#include <fmt/format.h>

#include "comparisons/results/known_results.hpp"
#include "comparisons/tables/cases_sheet.hpp"
#include "comparisons/tables/catalogue.hpp"

namespace springcheck {
namespace {

/// A request's result in the file.
using Find = std::function<std::optional<CaseResult>(const Request&)>;

std::optional<Table> stored_table(const std::string& name, const std::string& file,
                                  const Find& find) {
  TablePlan plan = plan_table(name, std::nullopt);
  std::vector<PlannedRow> rows;
  std::vector<CaseResult> results;  // in the order of table_requests
  for (const PlannedRow& row : plan.rows) {
    auto own = find(row.request);
    if (!own) continue;
    rows.push_back(row);
    results.push_back(std::move(*own));
    const std::string revision = results.back().revision;
    for (const CaseSettings& reference : reference_cases(row.request)) {
      auto found = find({.settings = reference});
      const bool is_of_row = found && found->revision == revision;
      results.push_back(is_of_row ? *std::move(found) : CaseResult{});
    }
  }
  if (rows.empty()) return std::nullopt;
  if (rows.size() < plan.rows.size())
    plan.notes.push_back(
        fmt::format("{} of {} rows: the result file lacks the cases of the others; "
                    "`springcheck table {} --from {}` computes them.",
                    rows.size(), plan.rows.size(), name, file));
  plan.rows = std::move(rows);
  add_note_of_taken(plan.notes, results);
  return fill_table(std::move(plan), results);
}

std::optional<Sheet> stored_sheet(const std::string& name, const Find& find,
                                  MeshStore& meshes) {
  const SheetPlan plan = plan_sheet(name);
  std::vector<CaseResult> results;
  for (const Request& request : plan.requests) {
    auto result = find(request);
    if (!result) return std::nullopt;
    if (!results.empty() && result->revision != results.front().revision)
      return std::nullopt;
    results.push_back(std::move(*result));
  }
  Sheet sheet = plan.make(results, meshes);
  add_note_of_taken(sheet.notes, results);
  return sheet;
}

}  // namespace

TableSet stored_tables(const std::filesystem::path& file, MeshStore& meshes,
                       Revisions revisions) {
  const StoredCases stored = stored_cases({file}, revisions);
  const auto finder = [&](const KnownResult& known) -> Find {
    return [&meshes, known](const Request& request) {
      return known(request, case_key(request, meshes.mesh(request.settings.body)));
    };
  };
  const Find figures = finder(known_figures(stored));
  const Find with_fields = finder(only_with_fields(known_from(stored, meshes)));
  TableSet set;
  for (const std::string& name : table_names())
    if (auto table = stored_table(name, file.filename().string(), figures))
      set.tables.push_back(std::move(*table));
  for (const std::string& name : sheet_names()) {
    if (name == "5.5" && set.tables.empty()) continue;  // needs no case: of the thesis
    if (std::ranges::count(caseless_sheet_names(), name) > 0) continue;
    if (auto sheet = stored_sheet(name, with_fields, meshes))
      set.sheets.push_back(std::move(*sheet));
  }
  if (!stored.empty()) {
    set.sheets.push_back(cases_sheet(read_cases(file, revisions)));
    std::vector<std::string>& notes = set.sheets.back().notes;
    if (const OtherRevisions taken = other_revisions(stored); !taken.empty())
      notes.push_back(note_of_taken(taken));
    else if (const std::string note =
                 note_of_other_revisions(stored_keys(file), revisions);
             !note.empty())
      notes.push_back("In the file: " + note + ".");
  }
  return set;
}

}  // namespace springcheck
