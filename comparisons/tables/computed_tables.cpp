#include "comparisons/tables/computed_tables.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <span>

#include "comparisons/results/known_results.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"

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

/// What is of one revision, or is computed: rows with their references, or whole tables.
std::vector<std::vector<Request>> groups_of(const std::vector<TablePlan>& plans) {
  std::vector<std::vector<Request>> groups;
  for (const TablePlan& plan : plans) {
    std::span<const Request> left = plan.requests;
    for (const std::size_t size : plan.row_sizes) {
      groups.emplace_back(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(size));
      left = left.subspan(size);
    }
    groups.emplace_back(left.begin(), left.end());
  }
  return groups;
}

}  // namespace

std::vector<Request> requests_behind(std::span<const CatalogueEntry* const> entries) {
  std::vector<Request> all;
  for (const CatalogueEntry* entry : entries) append(all, plan_of(*entry).requests);
  return all;
}

ComputedTables compute_tables(std::span<const CatalogueEntry* const> entries,
                              const std::optional<ReferenceMethod>& reference,
                              MeshStore& meshes, int parallel, const KnownResult& known,
                              const std::function<void(const CaseResult&)>& computed,
                              Revisions revisions) {
  std::vector<TablePlan> plans;
  std::vector<Request> all;
  for (const CatalogueEntry* entry : entries) {
    plans.push_back(plan_of(*entry, reference));
    append(all, plans.back().requests);
  }
  check_memory("table", all);
  const bool need_fields = std::ranges::any_of(plans, &TablePlan::needs_fields);
  KnownResult taken = known && need_fields ? only_with_fields(known) : known;
  if (revisions == Revisions::all)
    taken = in_whole_groups(taken, groups_of(plans), meshes);
  ComputedTables answer{.tables = {},
                        .results = results_of(all, meshes, parallel, taken, computed)};
  std::span<const CaseResult> left = answer.results;
  Progress progress("tables");  // of which some are computed without cases
  for (const TablePlan& plan : plans) {
    progress.show(answer.tables.size(), plans.size());
    const auto results = left.first(plan.requests.size());
    left = left.subspan(results.size());
    answer.tables.push_back(plan.make(results, meshes));
    add_note_of_taken(answer.tables.back().notes, results);
  }
  return answer;
}

}  // namespace springcheck
