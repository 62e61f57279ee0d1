#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <exception>
#include <map>
#include <memory>

#include "comparisons/command_line/options.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/options/computing.hpp"
#include "comparisons/commands/options/input_options.hpp"
#include "comparisons/commands/options/interrupted.hpp"
#include "comparisons/results/known_results.hpp"
#include "comparisons/running/cost.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/sweeps/planned_cases.hpp"
#include "comparisons/sweeps/sweep_run.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

constexpr std::size_t unasked = 1'000'000;

/// Every `of`-th case, from the `number`-th on.
struct Shard {
  int number = 1, of = 1;
};

struct SweepOptions {
  std::string sweep{};  // a file's name, or that of a shipped one
  std::filesystem::path out{};
  int jobs = all_cores();    // simulations at once, at most
  bool dry_run = false;      // count and estimate only
  bool only_failed = false;  // those the file holds with a status other than ok
  bool recompute = false;    // also what the file holds
  bool yes = false;          // more than a million combinations are meant
  Shard shard{};
  Revisions revisions = Revisions::own;
};

/// The cases that are to be computed.
std::vector<PlannedCase> missing_of(const std::vector<PlannedCase>& wanted,
                                    const StoredKeys& stored, const Sweep& sweep,
                                    MeshHashes& meshes, const SweepOptions& options) {
  if (stored.statuses.empty() && !options.only_failed) return wanted;
  std::vector<PlannedCase> missing;
  for (const PlannedCase& planned : wanted) {
    const Request request = request_of(sweep, planned);
    const std::string own_key =
        key_of_identity(case_identity(request, meshes.of(request.settings.body)));
    const auto other = stored.substitutes.find(own_key);
    const bool is_accepted =
        options.revisions == Revisions::all && other != stored.substitutes.end();
    const std::string& key = is_accepted ? other->second : own_key;
    const auto known = stored.statuses.find(key);
    const bool failed = known != stored.statuses.end() && known->second != Status::ok;
    if (options.only_failed ? failed
                            : options.recompute || !holds(stored, key, sweep.with_fields))
      missing.push_back(planned);
  }
  return missing;
}

std::string duration(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

/// Prints what the sweep would do.
void print_estimate(const std::vector<PlannedCase>& missing, const Sweep& sweep,
                    const SweepOptions& options) {
  double memory = 0;
  CostEstimate cost;
  for (const PlannedCase& planned : missing) {
    const Request request = request_of(sweep, planned);
    memory = std::max(memory, estimated_memory(request.settings));
    cost.add(request);
  }
  fmt::print("about {} on {} at once, {:.1f} GB for the largest\n",
             duration(cost.seconds() / options.jobs), options.jobs, memory / 1e9);
}

std::string counts(const std::map<Status, int>& count) {
  std::vector<std::string> all;
  for (const auto& [status, cases] : count)
    all.push_back(fmt::format("{} {}", cases, name_of(status)));
  return fmt::format("{}", fmt::join(all, ", "));
}

/// The shard that "I/N" means. Throws InputError unless 1 <= I <= N.
Shard shard_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto number = [&](std::string_view digits) {
    int value = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc{} && end == digits.data() + digits.size() ? value : 0;
  };
  Shard shard{0, 0};
  if (slash != std::string::npos) {
    shard.number = number(std::string_view(text).substr(0, slash));
    shard.of = number(std::string_view(text).substr(slash + 1));
  }
  if (shard.number < 1 || shard.number > shard.of)
    throw InputError("--shard", "", "I/N with 1 <= I <= N", "'" + text + "'");
  return shard;
}

/// Computes the cases the result file lacks and adds each as soon as it is complete.
ExitStatus run_sweep(const SweepOptions& options) {
  const Computing computing(options.jobs);
  const std::filesystem::path& file = options.out;
  const Sweep sweep = read_sweep(options.sweep, options.yes ? SIZE_MAX : unasked);
  MeshHashes meshes;
  const std::vector<PlannedCase> wanted =
      planned_cases(sweep, meshes, options.shard.number, options.shard.of);
  const auto told = [&](const std::vector<PlannedCase>& missing) {
    fmt::print("{}: {} cases, {} of them to compute\n", sweep.name, wanted.size(),
               missing.size());
    if (takes_usual_reference(sweep))
      fmt::print("deviations are from {}:{}, where a case names no other reference\n",
                 sweep.usual_reference.method.name, sweep.usual_reference.element.name);
  };
  if (options.dry_run) {  // beside a writer, too
    const bool exists = std::filesystem::exists(file);
    const std::vector<PlannedCase> missing = missing_of(
        wanted, exists ? stored_keys(file) : StoredKeys{}, sweep, meshes, options);
    told(missing);
    print_estimate(missing, sweep, options);
    return ExitStatus::done;
  }
  ResultFile results(file);
  if (sweep.with_fields) check_xdmf_writable(file);
  warn_of_other_revisions(file, results.stored(), options.revisions);
  const std::vector<PlannedCase> missing =
      missing_of(wanted, results.stored(), sweep, meshes, options);
  told(missing);
  const BeforeInterruption kept = tell_what_is_kept(
      file, options.recompute || options.only_failed
                ? "Without --recompute and --only-failed the sweep goes on from there."
                : "The same command goes on from there.");
  std::fflush(stdout);  // into a pipe, too, whatever becomes of what follows
  const SweepOutcome outcome = run_cases(results, sweep, missing, options.jobs);
  if (!outcome.count.empty()) fmt::print("computed: {}\n", counts(outcome.count));
  for (const auto& [reason, cases] : outcome.reasons)
    fmt::print("  {} {}, {}: {}\n", cases, name_of(reason.status), reason.method,
               reason.words);
  if (sweep.with_fields && !missing.empty()) write_xdmf_beside(file);
  if (outcome.failure) std::rethrow_exception(outcome.failure);
  return ExitStatus::done;
}

Action declare_sweep(CLI::App& parser) {
  const auto options = std::make_shared<SweepOptions>();
  parser.add_option("sweep", options->sweep, "name of a shipped sweep, or a .toml file")
      ->required()
      ->type_name("SWEEP|FILE");
  add_path(parser, "--out", options->out, "FILE", "HDF5 file to add the cases to")
      ->required();
  parser.add_flag("--dry-run", options->dry_run, "count and estimate only");
  parser.add_flag("--only-failed", options->only_failed,
                  "run again what the file holds with a status other than ok");
  parser.add_flag("--recompute", options->recompute, "run again all that the file holds");
  parser
      .add_option_function<std::string>(
          "--shard",
          [options](const std::string& text) { options->shard = shard_of(text); },
          "I/N: every N-th case from the I-th on")
      ->type_name("I/N");
  parser.add_flag("--yes", options->yes, "more than a million combinations are meant");
  add_revisions(parser, options->revisions, "cases in the file");
  add_jobs(parser, options->jobs, "simulations");
  return [options] { return run_sweep(*options); };
}

}  // namespace

Command sweep_command() {
  return {.name = "sweep",
          .summary = "Run the cases of a sweep that a result file lacks",
          .description =
              "A sweep is a scene over lists of settings. What was computed is "
              "kept, whatever ends the command: started again, it goes on.",
          .examples = {{"springcheck sweep nu --out nu.h5",
                        "springs and elements over Poisson's ratio"},
                       {"springcheck sweep nu --out nu.h5 --dry-run",
                        "how many cases that is, and how long it takes"},
                       {"springcheck sweep mine.toml --out part1.h5 --shard 1/2",
                        "half of a sweep of your own, on one of two machines"}},
          .declare = declare_sweep};
}

}  // namespace springcheck
