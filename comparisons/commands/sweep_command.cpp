#include "comparisons/commands/sweep_command.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <exception>
#include <map>

#include "comparisons/results/known_results.hpp"
#include "comparisons/running/cost.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/sweeps/planned_cases.hpp"
#include "comparisons/sweeps/sweep_run.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

constexpr std::size_t unasked = 1'000'000;

/// What is to be computed.
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
    // Of a refused case there never are fields.
    const bool is_there = known != stored.statuses.end() &&
                          (!sweep.with_fields || stored.with_fields.contains(key) ||
                           known->second == Status::refused);
    const bool failed = known != stored.statuses.end() && known->second != Status::ok;
    if (options.only_failed ? failed : options.recompute || !is_there)
      missing.push_back(planned);
  }
  return missing;
}

std::string duration(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

/// What the sweep would do.
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
  std::string text;
  for (const auto& [status, cases] : count)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", cases, name_of(status));
  return text;
}

}  // namespace

void set_shard(SweepOptions& options, const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto number = [&](std::string_view digits) {
    int value = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc{} && end == digits.data() + digits.size() ? value : 0;
  };
  if (slash != std::string::npos) {
    options.shard = number(std::string_view(text).substr(0, slash));
    options.shards = number(std::string_view(text).substr(slash + 1));
  }
  if (slash == std::string::npos || options.shard < 1 || options.shard > options.shards)
    throw InputError("--shard", "", "I/N with 1 <= I <= N", "'" + text + "'");
}

ExitStatus sweep_command(const std::string& name_or_path,
                         const std::filesystem::path& file, const SweepOptions& options) {
  const Sweep sweep = read_sweep(name_or_path, options.yes ? SIZE_MAX : unasked);
  MeshHashes meshes;
  const std::vector<PlannedCase> wanted =
      planned_cases(sweep, meshes, options.shard, options.shards);
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

}  // namespace springcheck
