#include "comparisons/commands/reproduce.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <ranges>
#include <set>
#include <span>

#include "comparisons/chart/chart_run.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/report/report.hpp"
#include "comparisons/results/known_results.hpp"
#include "comparisons/running/cost.hpp"
#include "comparisons/running/progress.hpp"
#include "comparisons/stability/atlas.hpp"
#include "comparisons/sweeps/sweep_file.hpp"
#include "comparisons/sweeps/sweep_run.hpp"
#include "comparisons/tables/computed_tables.hpp"
#include "comparisons/tables/summary.hpp"
#include "meshing/basics/output_file.hpp"

namespace springcheck {
namespace {

/// A part of what is to be done.
struct Stage {
  std::string what;
  double seconds;  // expected
  std::function<void()> run;
};

/// Runs the stages one after the other. Each is announced with the time that it and those
/// after it are expected to take, by how long those before took beside what was expected
/// of them.
void run_stages(const std::vector<Stage>& stages) {
  double expected = 0, taken = 0, left = 0;
  for (const Stage& stage : stages) left += stage.seconds;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const double pace = expected > 0 ? std::clamp(taken / expected, 0.5, 2.) : 1;
    announce(fmt::format("stage {} of {}, {}; about {:.0f} s left in all", i + 1,
                         stages.size(), stages[i].what, pace * left));
    const auto start = std::chrono::steady_clock::now();
    const Progress progress(stages[i].what);
    stages[i].run();
    const std::chrono::duration<double> seconds =
        std::chrono::steady_clock::now() - start;
    taken += seconds.count();
    expected += stages[i].seconds;
    left -= stages[i].seconds;
  }
}

StoredCases stored_in(const std::filesystem::path& file) {
  return std::filesystem::exists(file) ? stored_cases({file}, Revisions::own)
                                       : StoredCases{};
}

std::vector<const CatalogueEntry*> tables_of(Extent extent) {
  std::vector<const CatalogueEntry*> entries;
  for (const CatalogueEntry& entry : catalogue())
    if (extent == Extent::quick ? is_of_printed_figures(entry)
                                : extent == Extent::all || !takes_long(entry))
      entries.push_back(&entry);
  return entries;
}

bool is_computed_when_printed(const CatalogueEntry& entry) {
  return entry.source == Source::when_printed;
}

/// The requests that the file does not hold, with fields where they are wanted. Requests
/// in `planned` are left out, and the keys of the others are added to it.
std::vector<Request> missing_of(std::vector<Request> requests, bool with_fields,
                                const StoredKeys& stored, std::set<std::string>& planned,
                                MeshStore& meshes) {
  std::erase_if(requests, [&](const Request& request) {
    const std::string key = case_key(request, meshes.mesh(request.settings.body));
    return holds(stored, key, with_fields) || !planned.insert(key).second;
  });
  return requests;
}

/// The approximate time that the requests take on so many cores [s].
double seconds_of(std::span<const Request> requests, int parallel) {
  CostEstimate cost;
  for (const Request& request : requests) cost.add(request);
  return cost.seconds() / parallel;
}

ComputedTables compute_into(const std::filesystem::path& path,
                            std::span<const CatalogueEntry* const> tables,
                            MeshStore& meshes, int parallel) {
  ResultFile file(path);
  const StoredCases stored = stored_in(path);
  return compute_tables(tables, std::nullopt, meshes, parallel,
                        known_from(stored, meshes), [&](const CaseResult& result) {
                          file.put({&result, 1}, true, meshes);
                        });
}

/// Cases of a sweep.
struct SweptCases {
  bool with_fields;
  std::vector<Request> requests;
};

/// The cases that are missing of the shipped sweeps that the page shows, see missing_of.
/// Sweeps with fields come first: a case of two sweeps is computed once, by the first.
std::vector<SweptCases> missing_of_sweeps(const StoredKeys& stored,
                                          std::set<std::string>& planned,
                                          MeshStore& meshes) {
  std::vector<Sweep> sweeps;
  for (const char* name :
       {"nu", "refinement", "deformation", "diagonal-ratio", "beam-diagonal-ratio"})
    sweeps.push_back(read_sweep(name, SIZE_MAX));
  std::ranges::stable_partition(sweeps, &Sweep::with_fields);
  std::vector<SweptCases> missing;
  for (const Sweep& sweep : sweeps)
    missing.push_back(
        {sweep.with_fields,
         missing_of(all_requests(sweep), sweep.with_fields, stored, planned, meshes)});
  return missing;
}

std::size_t count_of(const std::vector<SweptCases>& sweeps) {
  std::size_t count = 0;
  for (const SweptCases& sweep : sweeps) count += sweep.requests.size();
  return count;
}

void run_sweeps(const std::filesystem::path& path, const std::vector<SweptCases>& sweeps,
                MeshStore& meshes, int parallel) {
  ResultFile file(path);
  const StoredCases stored = stored_in(path);
  const std::size_t all = count_of(sweeps);
  std::size_t before = 0;
  Progress progress("cases");
  for (const SweptCases& sweep : sweeps) {
    const Finished finished = [&](std::size_t done, std::size_t of) {
      progress.show(before + (of == 0 ? 0 : sweep.requests.size() * done / of), all);
    };
    SweepOutcome outcome;
    run_into(file, sweep.requests, sweep.with_fields, meshes, parallel,
             only_with_fields(known_from(stored, meshes)), finished, outcome);
    if (outcome.failure) std::rethrow_exception(outcome.failure);
    before += sweep.requests.size();
  }
}

/// The plan of a map of how the foremost springs and elements fail in compression, over
/// deformation and nu.
AtlasPlan map_plan() {
  constexpr std::size_t springs = 3, elements = 2;
  std::vector<std::string> names;
  for (const auto& [family, count] : {std::pair(Family::springs, springs),
                                      std::pair(Family::finite_elements, elements)})
    for (const Method* method : foremost(family) | std::views::take(count))
      names.push_back(method->name);
  const auto option = [](const char* key, const std::string& value) {
    return GivenSetting{key, Given::from_text("reproduce", value)};
  };
  return {.scene = "compression",
          .options = {option("method", fmt::format("{}", fmt::join(names, ","))),
                      option("cells", "4,4,4")},
          .axes = {axis_named("reproduce", "deformation=7.5%:60%:8"),
                   axis_named("reproduce", "nu=0:0.49:8")}};
}

/// The expected time of a scene's chart [s]: next to nothing where the file has some of
/// it.
double seconds_of_chart(const std::filesystem::path& file, std::string_view scene) {
  constexpr double on_two_cores = 45, begun = 5;
  if (!std::filesystem::exists(file)) return on_two_cores;
  const auto charts = read_charts(file, Revisions::own);
  return std::ranges::count(charts, scene, &StoredChart::scene) > 0 ? begun
                                                                    : on_two_cores;
}

/// Keeps a result file that has cases of other revisions under another name.
void set_aside(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return;
  const ResultFile opened(file);  // nobody else writes it meanwhile
  const OtherRevisions& others = opened.stored().others;
  if (others.empty()) return;
  const std::string name =
      fmt::format("{}-{}", file.stem().string(), others.begin()->first);
  std::filesystem::path kept = file.parent_path() / (name + ".h5");
  for (int i = 2; std::filesystem::exists(kept); ++i)
    kept = file.parent_path() / fmt::format("{}-{}.h5", name, i);
  std::filesystem::rename(file, kept);
  announce(fmt::format("{} has cases of another revision of the numerics: it is now {}",
                       file.string(), kept.string()));
}

/// The tables, of those computed, that a result file cannot give back.
std::vector<Table> not_in_files(const std::vector<Table>& tables) {
  std::vector<Table> found;
  std::ranges::copy_if(tables, std::back_inserter(found), [](const Table& table) {
    return is_computed_when_printed(table_named(table.name));
  });
  return found;
}

}  // namespace

ExitStatus reproduce(const std::filesystem::path& directory, Extent extent,
                     int parallel) {
  // Times on two cores:
  constexpr double seconds_of_map = 20, seconds_of_page = 60;
  const auto start = std::chrono::steady_clock::now();
  prepare_report(directory);
  const std::filesystem::path result_file = directory / "results.h5",
                              summary_file = directory / "summary.md";
  check_results_writable(result_file);
  check_writable(summary_file);

  set_aside(result_file);

  MeshStore meshes;
  ComputedTables computed;
  ExitStatus status{};
  std::vector<Stage> stages;
  const StoredKeys stored = ResultFile(result_file).stored();
  std::set<std::string> planned;
  const std::vector<const CatalogueEntry*> tables = tables_of(extent);
  double seconds_of_theory = 0;
  for (const CatalogueEntry* entry : tables)
    if (is_computed_when_printed(*entry)) seconds_of_theory += 60 * entry->minutes;
  const std::vector<Request> of_tables =
      missing_of(requests_behind(tables), true, stored, planned, meshes);
  stages.push_back({fmt::format("tables, {} cases", of_tables.size()),
                    seconds_of_theory + seconds_of(of_tables, parallel), [&] {
                      computed = compute_into(result_file, tables, meshes, parallel);
                    }});
  if (extent != Extent::quick) {
    const std::vector<SweptCases> sweeps = missing_of_sweeps(stored, planned, meshes);
    double seconds = 0;
    for (const SweptCases& sweep : sweeps)
      seconds += seconds_of(sweep.requests, parallel);
    stages.push_back(
        {fmt::format("sweeps, {} cases", count_of(sweeps)), seconds,
         [&, sweeps] { run_sweeps(result_file, sweeps, meshes, parallel); }});
    for (const char* scene : {"compression", "shearing", "torsion"})
      stages.push_back({fmt::format("quick chart of {}", scene),
                        seconds_of_chart(result_file, scene), [&, scene] {
                          make_chart(quick_plan(scene, parallel, parallel), result_file);
                        }});
    stages.push_back({"map of failures", seconds_of_map, [&] {
                        CaseRunner runner(result_file, parallel);
                        make_atlas(map_plan(), runner);
                      }});
  }
  stages.push_back(
      {"page", seconds_of_page, [&] {
         const std::chrono::duration<double> elapsed =
             std::chrono::steady_clock::now() - start;
         const auto statuses = stored_keys(result_file).statuses;
         announce(fmt::format("{} has {} cases", result_file.string(), statuses.size()));
         const std::string text = summary(computed.tables, statuses, elapsed.count());
         write_whole_stream(summary_file, [&](std::ostream& out) { out << text; });
         write_xdmf_beside(result_file);
         status = make_report(result_file, directory, not_in_files(computed.tables),
                              Revisions::own);
       }});
  run_stages(stages);
  return status;
}

}  // namespace springcheck
