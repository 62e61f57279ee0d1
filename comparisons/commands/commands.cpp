#include "comparisons/commands/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <exception>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/commands/quality_text.hpp"
#include "comparisons/commands/result_json.hpp"
#include "comparisons/commands/result_text.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/results/kept_results.hpp"
#include "comparisons/results/known_results.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/tables/computed_tables.hpp"
#include "comparisons/tables/studies/split_output.hpp"
#include "meshing/files/mesh_files.hpp"
#include "meshing/input_error.hpp"
#include "meshing/output_file.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

std::vector<Method> methods_of(const RunSettings& run) {
  std::vector<Method> all;
  for (const MethodChoice& choice : run.methods) all.push_back(choice.method);
  return all;
}

/// The splits of errors, of methods whose continuum is known, against the law of the
/// named reference, or that which the springs follow, or Hencky's; others have none.
/// Throws InputError where nothing can be split as asked.
std::vector<std::optional<SplitPlan>> split_plans(const RunSettings& run,
                                                  const std::vector<Request>& requests) {
  const auto has_continuum = [](const Method& method) {
    return method.lattice.has_value();
  };
  const std::vector<Method> asked = methods_of(run);
  if (std::ranges::none_of(asked, has_continuum))
    throw InputError("--split", "method",
                     "at least one of springs whose continuum fem-cauchy-born is: " +
                         names_of(lattices()),
                     names_of(asked));
  if (run.reference &&
      (run.reference->grid == ReferenceGrid::converged || !run.reference->cells.empty() ||
       run.reference->element.name != "q1-sri"))
    throw InputError(run.reference->place, "",
                     "a method alone with --split, which has its own elements and grids",
                     "'" + run.reference->text + "'");
  std::vector<std::optional<SplitPlan>> plans;
  for (const Request& request : requests) {
    const bool is_split = has_continuum(request.settings.method);
    const Solver solver = solver_of(request.settings);
    if (is_split && solver != Solver::static_equilibrium)
      throw InputError("--split", "solver",
                       "static: the end of dynamics and a limit have errors of their own",
                       std::string(name_of(solver)));
    const Method& law = run.reference ? run.reference->method
                                      : followed_law(request.settings, thesis_law());
    plans.push_back(is_split ? std::optional(plan_split(request.settings, law))
                             : std::nullopt);
  }
  return plans;
}

/// "8 prisms, 20 hexahedra".
std::string cell_counts(const Mesh& mesh) {
  std::string text;
  for (const CellType type : all_cell_types)
    if (const std::size_t count = mesh.count(type); count > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, plural_of(type));
  return text;
}

/// A checkpoint belongs to a single simulation through time, and is no result file.
void check_checkpoint(const RunSettings& run, const std::filesystem::path& file,
                      const std::optional<std::filesystem::path>& result_file) {
  const auto place = [](const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path));
  };
  if (result_file && place(file) == place(*result_file))
    throw InputError("--checkpoint", "", "another file than that of --out",
                     "'" + file.string() + "'");
  if (run.methods.size() != 1)
    throw InputError("--checkpoint", "", "one method",
                     fmt::to_string(run.methods.size()));
  const CaseSettings settings = with_method(run.common, run.methods.front());
  if (!goes_through_time(settings))
    throw InputError("--checkpoint", "", "a solver that goes through time",
                     std::string(name_of(solver_of(settings))));
  check_writable(file);
}

void print_results(const RunSettings& run, Output output,
                   const std::vector<CaseResult>& results,
                   const std::vector<std::optional<Split>>& splits, MeshStore& meshes) {
  if (output == Output::json) {
    fmt::print("{}\n", run_json(run.common.scene, results, splits, meshes).dump(2));
    return;
  }
  fmt::print("{}", results_text(results));
  for (const auto& split : splits)
    if (split) fmt::print("\n{}", split_text(*split));
}

bool has_failed(const std::vector<CaseResult>& results,
                const std::vector<Status>& expected, FailOn fail_on) {
  const auto failed = static_cast<std::size_t>(
      std::ranges::count_if(results, [&](const CaseResult& result) {
        return std::ranges::count(expected, result.status) == 0;
      }));
  switch (fail_on) {
    case FailOn::any:
      return failed > 0;
    case FailOn::all:
      return failed == results.size();
    case FailOn::none:
      return false;
  }
  throw std::logic_error("a FailOn that is none");
}

}  // namespace

ExitStatus run_command(const std::string& scene, const std::vector<GivenSetting>& given,
                       const RunOptions& options, const Watch& watch) {
  const RunSettings run = read_run(scene, given);
  if (watch.checkpoint) check_checkpoint(run, *watch.checkpoint, options.out);
  std::vector<Request> all = requests(run);
  const std::size_t asked = all.size();
  std::vector<std::optional<SplitPlan>> plans(asked);
  if (options.error_split == ErrorSplit::wanted) plans = split_plans(run, all);
  for (const auto& plan : plans)
    if (plan) {
      const std::vector<Request> needed = split_requests(*plan);
      all.insert(all.end(), needed.begin(), needed.end());
    }
  // One at a time, unless the grids of a split make it long.
  const int at_once = all.size() > asked ? options.parallel : 1;
  check_memory(run.cells_place, all);

  MeshStore meshes;
  std::optional<KeptResults> kept;
  if (options.out) kept.emplace(*options.out, meshes);
  std::vector<CaseResult> results(all.size());
  std::exception_ptr failure;  // of a case; the others are still told
  {
    Progress progress("simulations");
    const Finished show = [&](std::size_t done, std::size_t of) {
      if (all.size() > 1) progress.show(done, of);
    };
    const Deliver take = [&](std::size_t request, CaseResult&& result) {
      results[request] = std::move(result);  // computed, whatever becomes of the file
      if (kept) kept->keep(results[request]);
    };
    try {
      run_study(all, meshes, at_once, show, {}, take, watch);
    } catch (...) {
      failure = std::current_exception();
      results.resize(asked);
      std::erase_if(results, [](const CaseResult& result) { return result.key.empty(); });
      if (results.empty()) throw;
    }
  }
  if (failure) {
    const std::vector<std::optional<Split>> none(results.size());
    print_results(run, options.output, results, none, meshes);
  }
  if (kept) kept->finish(results, {});
  if (failure) std::rethrow_exception(failure);
  std::vector<std::optional<Split>> splits(asked);
  std::span<const CaseResult> grids = std::span(results).subspan(asked);
  for (std::size_t i = 0; i < asked; ++i)
    if (plans[i]) {
      const std::size_t count = split_requests(*plans[i]).size();
      splits[i] = split_error(*plans[i], results[i], grids.first(count), meshes);
      grids = grids.subspan(count);
    }
  results.resize(asked);
  print_results(run, options.output, results, splits, meshes);

  const FailOn fail_on =
      options.fail_on.value_or(asked == 1 ? FailOn::any : FailOn::none);
  return has_failed(results, run.expect, fail_on) ? ExitStatus::unexpected_status
                                                  : ExitStatus::done;
}

ExitStatus table_command(const std::string& name, const TableFiles& files,
                         const std::string& reference, TableFormat format, int parallel) {
  if (name.empty())
    throw InputError("springcheck table", "name", "the name of a table, or --list",
                     "neither");
  const CatalogueEntry* const entry = &table_named(name);
  const auto& [from, out, revisions] = files;
  const StoredCases stored = stored_cases(from, revisions);
  for (const std::filesystem::path& file : from)
    warn_of_other_revisions(file, stored_keys(file), revisions);
  std::optional<ReferenceMethod> chosen;
  if (!reference.empty())
    chosen = reference_named(Given::from_text("--reference", reference));
  if (chosen && chosen->method.belongs_to_cells)
    throw InputError(chosen->place, "", "a method without constants of its own",
                     "'" + chosen->method.name + "'");
  MeshStore meshes;
  std::optional<KeptResults> kept;
  if (out) kept.emplace(*out, meshes);
  const ComputedTables computed = compute_tables(
      {&entry, 1}, chosen, meshes, parallel, known_from(stored, meshes),
      [&](const CaseResult& result) {
        if (kept) kept->keep(result);
      },
      revisions);
  if (kept) kept->finish(computed.results, from);
  for (const Table& table : computed.tables)
    fmt::print("{}", format_table(table, format));
  return ExitStatus::done;
}

ExitStatus list_tables_command(const std::optional<TableFormat>& format) {
  const Table tables = table_of_tables();
  fmt::print(
      "{}", format ? format_table(tables, *format)
                   : table_in_columns(tables, {"section"}) + tables.notes.front() + "\n");
  return ExitStatus::done;
}

ExitStatus mesh_command(const std::string& scene,
                        const std::vector<GivenSetting>& options,
                        const std::optional<std::filesystem::path>& file,
                        MeshReport report) {
  if (!file && report == MeshReport::counts)
    throw InputError("--out", "", "a .msh, .vtu or .inp file, or --quality alone",
                     "neither");
  const RunSettings run = read_run(scene, options);
  check_mesh_memory(run.cells_place, run.common.body);
  if (file) check_writable(*file);
  const Mesh mesh = build_mesh(run.common.body);
  if (file) write_mesh(mesh, *file);
  fmt::print("{}: {} nodes, {}, {:.6g} m^3, SHA-256 {}\n",
             file ? file->string() : mesh.source(), mesh.nodes().size(),
             cell_counts(mesh), mesh.volume(), mesh.sha256());
  if (!mesh.surfaces_elsewhere().empty())
    fmt::print("surfaces that are not on the boundary, and hold nothing: {}\n",
               fmt::join(mesh.surfaces_elsewhere(), ", "));
  if (report == MeshReport::quality) fmt::print("\n{}", quality_text(quality_of(mesh)));
  return ExitStatus::done;
}

}  // namespace springcheck
