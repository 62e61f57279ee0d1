#include "comparisons/tables/computed_tables.hpp"

#include <algorithm>
#include <set>

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

void append(std::vector<Request>& all, const std::vector<Request>& further) {
  all.insert(all.end(), further.begin(), further.end());
}

}  // namespace

ComputedTables compute_tables(const std::vector<std::string>& names,
                              const std::optional<ReferenceMethod>& reference,
                              MeshStore& meshes, int parallel, const KnownResult& known,
                              const std::function<void(const CaseResult&)>& computed) {
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
  const bool need_fields = known && !sheets.empty();
  ComputedTables answer{
      .set = {},
      .results = results_of(all, meshes, parallel,
                            need_fields ? only_with_fields(known) : known, computed)};
  auto next = answer.results.begin();
  for (TablePlan& plan : plans) {
    const auto count = static_cast<std::ptrdiff_t>(table_requests(plan).size());
    answer.set.tables.push_back(fill_table(std::move(plan), {next, next + count}));
    next += count;
  }
  for (const SheetPlan& plan : sheets) {
    const std::size_t count = plan.requests.size();
    answer.set.sheets.push_back(plan.make({next, count}, meshes));
    next += static_cast<std::ptrdiff_t>(count);
  }
  return answer;
}

}  // namespace springcheck
