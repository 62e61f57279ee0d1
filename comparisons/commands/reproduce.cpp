#include "comparisons/commands/reproduce.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "comparisons/commands/report_command.hpp"
#include "comparisons/results/known_results.hpp"
#include "comparisons/running/progress.hpp"
#include "comparisons/sweeps/sweep_file.hpp"
#include "comparisons/sweeps/sweep_run.hpp"
#include "comparisons/tables/catalogue.hpp"
#include "comparisons/tables/summary.hpp"
#include "meshing/output_file.hpp"

namespace springcheck {
namespace {

StoredCases stored_in(const std::filesystem::path& file) {
  return std::filesystem::exists(file) ? stored_cases({file}, Revisions::own)
                                       : StoredCases{};
}

ComputedTables compute_into(ResultFile& file, const std::filesystem::path& path,
                            Extent extent, MeshStore& meshes, int parallel) {
  std::vector<std::string> names = table_names();
  for (const std::string& name : sheet_names())
    if (extent == Extent::all || std::ranges::count(long_sheet_names(), name) == 0)
      names.push_back(name);
  const StoredCases stored = stored_in(path);
  return compute_tables(names, std::nullopt, meshes, parallel, known_from(stored, meshes),
                        [&](const CaseResult& result) {
                          file.put({&result, 1}, true, meshes);
                        });
}

/// Adds what is neither stored nor among `done`, by key.
void sweep_into(ResultFile& file, const std::filesystem::path& path,
                std::set<std::string> done, MeshStore& meshes, int parallel) {
  const StoredCases stored = stored_in(path);
  for (const char* name :
       {"nu", "refinement", "deformation", "diagonal-ratio", "beam-diagonal-ratio"}) {
    const Sweep sweep = read_sweep(name, SIZE_MAX);
    std::vector<Request> missing;
    for (const Request& request : all_requests(sweep)) {
      const std::string key = case_key(request, meshes.mesh(request.settings.body));
      const bool has_fields =
          !sweep.with_fields || file.stored().with_fields.contains(key);
      if ((!stored.contains(key) || !has_fields) && done.insert(key).second)
        missing.push_back(request);
    }
    SweepOutcome outcome;
    Progress progress("simulations");
    run_into(
        file, missing, sweep.with_fields, meshes, parallel,
        only_with_fields(known_from(stored, meshes)),
        [&](std::size_t now, std::size_t of) { progress.show(now, of); }, outcome);
    if (outcome.failure) std::rethrow_exception(outcome.failure);
  }
}

}  // namespace

ExitStatus reproduce_command(const std::filesystem::path& directory, Extent extent,
                             int parallel) {
  const auto start = std::chrono::steady_clock::now();
  prepare_report(directory);
  const std::filesystem::path result_file = directory / "results.h5",
                              summary_file = directory / "summary.md";
  check_results_writable(result_file);
  check_writable(summary_file);

  MeshStore meshes;
  std::vector<Sheet> not_stored;
  {
    ResultFile file(result_file);
    const ComputedTables computed =
        compute_into(file, result_file, extent, meshes, parallel);
    const std::chrono::duration<double> elapsed =
        std::chrono::steady_clock::now() - start;
    write_whole_stream(summary_file, [&](std::ostream& out) {
      out << summary(computed, elapsed.count());
    });
    std::ranges::copy_if(
        computed.set.sheets, std::back_inserter(not_stored), [](const Sheet& sheet) {
          return std::ranges::count(caseless_sheet_names(), sheet.name) > 0;
        });
    std::set<std::string> done;
    for (const CaseResult& result : computed.results) done.insert(result.key);
    sweep_into(file, result_file, std::move(done), meshes, parallel);
  }
  write_xdmf_beside(result_file);
  return make_report(result_file, directory, not_stored, Revisions::own);
}

}  // namespace springcheck
