#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>

#include "comparisons/command_line/options.hpp"
#include "comparisons/command_line/screen.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/options/computing.hpp"
#include "comparisons/commands/options/input_options.hpp"
#include "comparisons/commands/options/interrupted.hpp"
#include "comparisons/commands/options/setting_options.hpp"
#include "comparisons/commands/output/result_json.hpp"
#include "comparisons/commands/output/result_text.hpp"
#include "comparisons/commands/run_splits.hpp"
#include "comparisons/results/kept_results.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/tables/studies/split_output.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/output_file.hpp"

namespace springcheck {
namespace {

enum class FailOn { any, all, none };

}  // namespace

template <>
inline constexpr std::array value_names<FailOn>{
    Named{FailOn::any, "any"}, Named{FailOn::all, "all"}, Named{FailOn::none, "none"}};

namespace {

struct RunOptions {
  std::string scene{};
  SettingOptions settings{};
  std::optional<std::filesystem::path> out{};  // result file
  std::optional<TableFormat> format{};
  bool splits_errors = false;
  std::string fail_on{};
  Watch watch{.shows_progress = true};
  int threads = all_cores();  // that split the error
};

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

void print_results(const RunSettings& run, const std::optional<TableFormat>& format,
                   const std::vector<CaseResult>& results,
                   const std::vector<std::optional<Split>>& splits, MeshStore& meshes) {
  print_results(run.common.scene, results, splits, format, meshes);
  if (format) return;
  for (const auto& split : splits)
    if (split) fmt::print("\n{}", split_text(*split));
}

/// The statuses that make the run fail where one of the cases ends in one of them.
/// Without any, what --fail-on says of statuses that the scene does not expect.
struct Failing {
  FailOn unexpected;
  std::vector<Status> listed{};
};

/// The statuses that --fail-on names. Where it says nothing it is `any` for one method
/// and `none` for several.
Failing failing_statuses(const std::string& text, std::size_t methods) {
  if (text.empty()) return {methods == 1 ? FailOn::any : FailOn::none};
  if (const auto* const rule = find_value<FailOn>(text)) return {rule->value};
  const Given given = Given::from_text("--fail-on", text);
  std::vector<std::string_view> names = all_names<FailOn>();
  for (const std::string_view status : all_names<Status>()) names.push_back(status);
  Failing failing{FailOn::none};
  for (const std::string& name : given.texts()) {
    if (find_value<FailOn>(name) != nullptr)
      given.refuse("any, all or none alone, or a list of statuses");
    const auto* const status = find_value<Status>(name);
    if (status == nullptr) given.refuse_name(name, names);
    failing.listed.push_back(status->value);
  }
  return failing;
}

bool has_failed(const std::vector<CaseResult>& results,
                const std::vector<Status>& expected, const Failing& failing) {
  const auto is_listed = [&](const CaseResult& result) {
    return std::ranges::any_of(failing.listed, [&](Status status) {
      return result.status == status || std::ranges::count(result.flags, status) > 0;
    });
  };
  const auto is_unexpected = [&](const CaseResult& result) {
    return std::ranges::count(expected, result.status) == 0;
  };
  if (!failing.listed.empty()) return std::ranges::any_of(results, is_listed);
  switch (failing.unexpected) {
    case FailOn::any:
      return std::ranges::any_of(results, is_unexpected);
    case FailOn::all:
      return std::ranges::all_of(results, is_unexpected);
    case FailOn::none:
      return false;
  }
  throw std::logic_error("a FailOn that is none");
}

/// A run, what it computes beyond what was asked for, and what came of it.
struct Simulations {
  std::vector<Request> requests;  // those asked for, then the grids of the splits
  std::size_t asked;
  std::vector<std::optional<SplitPlan>> plans;  // of those asked for
  std::vector<CaseResult> results{};            // in the order of the requests
  std::exception_ptr failure{};                 // of a case; the others are still told
};

Simulations planned(const RunSettings& run, bool splits_errors) {
  Simulations all{.requests = requests(run), .asked = 0, .plans = {}};
  all.asked = all.requests.size();
  all.plans.resize(all.asked);
  if (splits_errors) all.plans = split_plans(run, all.requests);
  for (const auto& plan : all.plans)
    if (plan) {
      const std::vector<Request> needed = split_requests(*plan);
      all.requests.insert(all.requests.end(), needed.begin(), needed.end());
    }
  return all;
}

/// Computes all simulations. Where a case fails, those asked for that were computed stay.
/// Throws where none was.
void compute(Simulations& all, const RunOptions& options,
             std::optional<KeptResults>& kept, MeshStore& meshes) {
  // Simulations run one at a time, unless the grids of a split make the run long.
  const int at_once = all.requests.size() > all.asked ? options.threads : 1;
  all.results.resize(all.requests.size());
  Progress progress("simulations");
  const Finished show = [&](std::size_t done, std::size_t of) {
    if (all.requests.size() > 1) progress.show(done, of);
  };
  const Deliver take = [&](std::size_t request, CaseResult&& result) {
    all.results[request] = std::move(result);  // computed, whatever becomes of the file
    if (kept) kept->keep(all.results[request]);
  };
  try {
    run_study(all.requests, meshes, at_once, show, {}, take, options.watch);
  } catch (...) {
    all.failure = std::current_exception();
    all.results.resize(all.asked);
    std::erase_if(all.results,
                  [](const CaseResult& result) { return result.key.empty(); });
    if (all.results.empty()) throw;
  }
}

/// The splits of the cases that were asked for.
std::vector<std::optional<Split>> splits_of(const Simulations& all, MeshStore& meshes) {
  std::vector<std::optional<Split>> splits(all.asked);
  std::span<const CaseResult> grids = std::span(all.results).subspan(all.asked);
  for (std::size_t i = 0; i < all.asked; ++i)
    if (all.plans[i]) {
      const std::size_t count = split_requests(*all.plans[i]).size();
      splits[i] = split_error(*all.plans[i], all.results[i], grids.first(count), meshes);
      grids = grids.subspan(count);
    }
  return splits;
}

ExitStatus run(const RunOptions& options) {
  if (options.splits_errors && options.format && options.format != TableFormat::json)
    throw InputError("--split", "", "--format json, or text for people",
                     fmt::format("--format {}", name_of(*options.format)));
  const Computing computing(options.threads);
  const RunSettings settings = read_run(options.scene, options.settings.given());
  const Failing failing = failing_statuses(options.fail_on, settings.methods.size());
  if (options.watch.checkpoint)
    check_checkpoint(settings, *options.watch.checkpoint, options.out);
  Simulations all = planned(settings, options.splits_errors);
  check_memory(settings.cells_place, all.requests);

  MeshStore meshes;
  std::optional<KeptResults> kept;
  if (options.out) kept.emplace(*options.out, meshes);
  const BeforeInterruption told =
      options.watch.checkpoint
          ? tell_that_it_goes_on(options.watch.checkpoint)
          : tell_what_is_kept(options.out, "The same command computes all again.");
  compute(all, options, kept, meshes);
  if (all.failure) {
    const std::vector<std::optional<Split>> none(all.results.size());
    print_results(settings, options.format, all.results, none, meshes);
  }
  if (kept) kept->finish(all.results, {});
  if (all.failure) std::rethrow_exception(all.failure);
  const std::vector<std::optional<Split>> splits = splits_of(all, meshes);
  all.results.resize(all.asked);
  print_results(settings, options.format, all.results, splits, meshes);
  return has_failed(all.results, settings.expect, failing) ? ExitStatus::unexpected_status
                                                           : ExitStatus::done;
}

Action declare_run(CLI::App& parser) {
  const auto options = std::make_shared<RunOptions>();
  add_scene(parser, options->scene);
  options->settings.add_to(parser, is_any);
  add_path(parser, "--out", options->out, "FILE", "HDF5 file for measures and fields")
      ->group(of_output);
  add_formats(parser, options->format);
  parser
      .add_option(
          "--fail-on", options->fail_on,
          "when the exit status is 3: any, where one of the methods ends in a "
          "status that the scene does not expect; all, where all do; none, never; "
          "or a list such as diverged,not_converged, where one ends in a status "
          "of it (default: any with one method; none with several: they may all "
          "fail, and the exit status is 0)")
      ->type_name("any|all|none|STATUS")
      ->group(of_output);
  parser
      .add_flag("--split", options->splits_errors,
                "split the errors of spring methods into law and discretisation; runs "
                "finite elements on up to 4 times as many cells along each axis")
      ->group(of_output);
  CLI::Option* const checkpoint =
      add_path(parser, "--checkpoint", options->watch.checkpoint, "FILE",
               "HDF5 file to which dynamics is saved on the way, and from which it goes "
               "on if it is there")
          ->group(of_output);
  add_seconds(parser, "--checkpoint-every", options->watch.seconds_between_checkpoints,
              true, "seconds between two savings")
      ->needs(checkpoint)
      ->group(of_output);
  add_revisions(parser, options->watch.revisions, "with --checkpoint: saved states")
      ->needs(checkpoint);
  add_threads(parser, options->threads);
  return [options] { return run(*options); };
}

}  // namespace

Command run_command() {
  return {
      .name = "run",
      .summary = "Run one scene with one or more methods",
      .description =
          "Options replace what the scene says. Several methods may all fail, "
          "and the exit status is 0 unless --fail-on says otherwise.",
      .examples = {{"springcheck run compression",
                    "the scene's methods beside their reference"},
                   {"springcheck run shearing --method mss-affine,fem-stvk:q2 --nu 0.45 "
                    "--cells 8,8,8",
                    "two methods on a mesh and a material of your own"},
                   {"springcheck run torsion --deformation 45deg --out results.h5",
                    "keeps measures and fields for tables, gates and the page"}},
      .declare = declare_run};
}

}  // namespace springcheck
