#include "comparisons/tables/stored_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/results/known_results.hpp"
#include "comparisons/tables/all_cases_table.hpp"
#include "comparisons/tables/catalogue.hpp"

namespace springcheck {
namespace {

/// A request's result in the file.
using Find = std::function<std::optional<CaseResult>(const Request&)>;

std::optional<Table> filled_rows(const CatalogueEntry& entry, const std::string& file,
                                 const Find& find, MeshStore& meshes) {
  const TablePlan plan = plan_of(entry);
  std::vector<std::size_t> rows;
  std::vector<CaseResult> results;
  std::span<const Request> left = plan.requests;
  for (std::size_t row = 0; row < plan.row_sizes.size(); ++row) {
    const auto requests = left.first(plan.row_sizes[row]);
    left = left.subspan(requests.size());
    auto own = find(requests.front());
    if (!own) continue;
    rows.push_back(row);
    results.push_back(std::move(*own));
    const std::string revision = results.back().revision;
    for (const Request& reference : requests.subspan(1)) {
      auto found = find(reference);
      const bool is_of_row = found && found->revision == revision;
      results.push_back(is_of_row ? *std::move(found) : CaseResult{});
    }
  }
  if (rows.empty()) return std::nullopt;
  Table table = plan.of_rows(rows).make(results, meshes);
  if (rows.size() < plan.row_sizes.size())
    table.notes.push_back(
        fmt::format("{} of {} rows: the result file lacks the cases of the others; "
                    "`springcheck table {} --from {}` computes them.",
                    rows.size(), plan.row_sizes.size(), entry.name, file));
  add_note_of_taken(table.notes, results);
  return table;
}

/// The table of all results; none where one is lacking.
std::optional<Table> filled_whole(const CatalogueEntry& entry, const Find& find,
                                  MeshStore& meshes) {
  const TablePlan plan = plan_of(entry);
  std::vector<CaseResult> results;
  for (const Request& request : plan.requests) {
    auto result = find(request);
    if (!result) return std::nullopt;
    if (!results.empty() && result->revision != results.front().revision)
      return std::nullopt;
    results.push_back(std::move(*result));
  }
  Table table = plan.make(results, meshes);
  add_note_of_taken(table.notes, results);
  return table;
}

}  // namespace

std::vector<Table> stored_tables(const std::filesystem::path& file, MeshStore& meshes,
                                 Revisions revisions) {
  const StoredCases stored = stored_cases({file}, revisions);
  const auto finder = [&](const KnownResult& known) -> Find {
    return [&meshes, known](const Request& request) {
      return known(request, case_key(request, meshes.mesh(request.settings.body)));
    };
  };
  const Find figures = finder(known_figures(stored));
  const Find with_fields = finder(only_with_fields(known_from(stored, meshes)));
  const std::string name = file.filename().string();
  std::vector<Table> tables;
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.source == Source::when_printed ||
        (entry.source == Source::counting && tables.empty()))
      continue;
    auto table = is_of_printed_figures(entry) ? filled_rows(entry, name, figures, meshes)
                                              : filled_whole(entry, with_fields, meshes);
    if (table) tables.push_back(std::move(*table));
  }
  if (!stored.empty()) {
    tables.push_back(all_cases_table(read_cases(file, revisions)));
    std::vector<std::string>& notes = tables.back().notes;
    if (const OtherRevisions taken = other_revisions(stored); !taken.empty())
      notes.push_back(note_of_taken(taken));
    else if (const std::string note =
                 note_of_other_revisions(stored_keys(file), revisions);
             !note.empty())
      notes.push_back("In the file: " + note + ".");
  }
  return tables;
}

}  // namespace springcheck
