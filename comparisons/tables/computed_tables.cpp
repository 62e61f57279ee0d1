#include "comparisons/tables/computed_tables.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <span>

#include "comparisons/results/known_results.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"
#include "comparisons/tables/catalogue.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

std::vector<CaseResult> results_of(
    const std::vector<Request>& requests, MeshStore& meshes, int parallel,
    const KnownResult& known, const std::function<void(const CaseResult&)>& computed) {
  Progress progress("simulations");
  std::vector<CaseResult> results(requests.size());
  std::set<std::string> known_keys;
  const KnownResult noted = [&](const Request& request, const std::string& key) {
    auto result = known ? known(request, key) : std::nullopt;
    if (result) known_keys.insert(result->key);  // in its file, if of another revision
    return result;
  };
  run_study(
      requests, meshes, parallel,
      [&](std::size_t done, std::size_t of) { progress.show(done, of); }, noted,
      [&](std::size_t request, CaseResult&& result) {
        if (computed && !known_keys.contains(result.key)) computed(result);
        results[request] = std::move(result);
      });
  return results;
}

/// What is known, without those results of other revisions that would stand beside others
/// in their group: a figure beside a reference of other numerics compares programs.
KnownResult in_whole_groups(const KnownResult& known,
                            const std::vector<std::vector<Request>>& groups,
                            MeshStore& meshes) {
  std::map<std::string, std::string> revisions;  // by key; none of what is computed
  std::vector<std::vector<std::string>> keys;
  for (const std::vector<Request>& group : groups)
    for (keys.emplace_back(); const Request& request : group) {
      const std::string key = case_key(request, meshes.mesh(request.settings.body));
      keys.back().push_back(key);
      if (revisions.contains(key)) continue;
      const auto result = known(request, key);
      revisions[key] = result ? result->revision : "";
    }
  std::set<std::string> dropped;
  for (bool is_done = false; !is_done;) {
    is_done = true;
    for (const std::vector<std::string>& group : keys) {
      std::set<std::string> seen;
      for (const std::string& key : group) seen.insert(revisions.at(key));
      if (seen.size() < 2) continue;
      for (const std::string& key : group)
        if (!revisions.at(key).empty()) {
          dropped.insert(key);
          revisions.at(key).clear();
          is_done = false;
        }
    }
  }
  return [known, dropped](const Request& request, const std::string& key) {
    return dropped.contains(key) ? std::nullopt : known(request, key);
  };
}

void append(std::vector<Request>& all, const std::vector<Request>& further) {
  all.insert(all.end(), further.begin(), further.end());
}

/// Rows with their references, and sheets.
std::vector<std::vector<Request>> groups_of(const std::vector<TablePlan>& tables,
                                            const std::vector<SheetPlan>& sheets) {
  std::vector<std::vector<Request>> groups;
  for (const TablePlan& table : tables)
    for (const PlannedRow& row : table.rows) {
      groups.push_back({row.request});
      for (const CaseSettings& reference : reference_cases(row.request))
        groups.back().push_back({.settings = reference});
    }
  for (const SheetPlan& sheet : sheets) groups.push_back(sheet.requests);
  return groups;
}

}  // namespace

std::vector<Request> requests_behind(const std::vector<std::string>& names) {
  std::vector<Request> all;
  for (const std::string& name : names)
    append(all, std::ranges::count(sheet_names(), name) > 0
                    ? plan_sheet(name).requests
                    : table_requests(plan_table(name, std::nullopt)));
  return all;
}

ComputedTables compute_tables(const std::vector<std::string>& names,
                              const std::optional<ReferenceMethod>& reference,
                              MeshStore& meshes, int parallel, const KnownResult& known,
                              const std::function<void(const CaseResult&)>& computed,
                              Revisions revisions) {
  std::vector<TablePlan> plans;
  std::vector<SheetPlan> sheets;
  std::vector<Request> all, of_sheets;
  for (const std::string& name : names) {
    check_table_name(name);
    if (std::ranges::count(sheet_names(), name) > 0) {
      if (reference)
        throw InputError(reference->place, "", "no reference: table " + name + " has its",
                         "one");
      sheets.push_back(plan_sheet(name));
      append(of_sheets, sheets.back().requests);
    } else {
      plans.push_back(plan_table(name, reference));
      append(all, table_requests(plans.back()));
    }
  }
  append(all, of_sheets);
  check_memory("table", all);
  KnownResult taken = known && !sheets.empty() ? only_with_fields(known) : known;
  if (revisions == Revisions::all)
    taken = in_whole_groups(taken, groups_of(plans, sheets), meshes);
  ComputedTables answer{.set = {},
                        .results = results_of(all, meshes, parallel, taken, computed)};
  auto next = answer.results.begin();
  for (TablePlan& plan : plans) {
    const auto count = static_cast<std::ptrdiff_t>(table_requests(plan).size());
    const std::vector<CaseResult> results{next, next + count};
    add_note_of_taken(plan.notes, results);
    answer.set.tables.push_back(fill_table(std::move(plan), results));
    next += count;
  }
  Progress progress("tables of our own");  // of which some are computed without cases
  for (const SheetPlan& plan : sheets) {
    progress.show(answer.set.sheets.size(), sheets.size());
    const std::size_t count = plan.requests.size();
    const std::span<const CaseResult> results(next, count);
    answer.set.sheets.push_back(plan.make(results, meshes));
    add_note_of_taken(answer.set.sheets.back().notes, results);
    next += static_cast<std::ptrdiff_t>(count);
  }
  return answer;
}

}  // namespace springcheck
