#include "comparisons/commands/sweep_command.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <map>
#include <set>

#include "comparisons/results/known_results.hpp"
#include "comparisons/running/cost.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/sweeps/sweep_file.hpp"
#include "comparisons/sweeps/sweep_run.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

constexpr std::size_t unasked = 1'000'000;

/// The requests of this shard, each key once, and their keys.
struct Wanted {
  std::vector<Request> requests;
  std::vector<std::string> keys;
};

Wanted wanted_of(const Sweep& sweep, const SweepOptions& options, MeshStore& meshes) {
  Wanted wanted;
  std::set<std::string> seen;
  for (const Request& request : sweep.requests) {
    const std::string key = case_key(request, meshes.mesh(request.settings.body));
    if (!seen.insert(key).second) continue;
    const auto place =
        static_cast<int>((seen.size() - 1) % static_cast<std::size_t>(options.shards));
    if (place + 1 != options.shard) continue;
    wanted.requests.push_back(request);
    wanted.keys.push_back(key);
  }
  return wanted;
}

/// What is to be computed.
std::vector<Request> missing_of(const Wanted& wanted, const StoredKeys& stored,
                                const Sweep& sweep, const SweepOptions& options) {
  std::vector<Request> missing;
  for (std::size_t i = 0; i < wanted.keys.size(); ++i) {
    const auto other = stored.substitutes.find(wanted.keys[i]);
    const bool is_accepted =
        options.revisions == Revisions::all && other != stored.substitutes.end();
    const std::string& key = is_accepted ? other->second : wanted.keys[i];
    const auto known = stored.statuses.find(key);
    // Of a refused case there never are fields.
    const bool is_there = known != stored.statuses.end() &&
                          (!sweep.with_fields || stored.with_fields.contains(key) ||
                           known->second == Status::refused);
    const bool failed = known != stored.statuses.end() && known->second != Status::ok;
    if (options.only_failed ? failed : options.recompute || !is_there)
      missing.push_back(wanted.requests[i]);
  }
  return missing;
}

std::string duration(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

/// What the sweep would do.
void print_estimate(const std::vector<Request>& missing, const SweepOptions& options) {
  double memory = 0;
  for (const Request& request : missing)
    memory = std::max(memory, estimated_memory(request.settings));
  fmt::print("about {} on {} at once, {:.1f} GB for the largest\n",
             duration(estimated_seconds(missing) / options.jobs), options.jobs,
             memory / 1e9);
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
  check_memory(name_or_path, sweep.requests);
  MeshStore meshes;
  const Wanted wanted = wanted_of(sweep, options, meshes);
  if (options.dry_run) {  // beside a writer, too
    const bool exists = std::filesystem::exists(file);
    const std::vector<Request> missing =
        missing_of(wanted, exists ? stored_keys(file) : StoredKeys{}, sweep, options);
    fmt::print("{}: {} cases, {} of them to compute\n", sweep.name, wanted.keys.size(),
               missing.size());
    print_estimate(missing, options);
    return ExitStatus::done;
  }
  ResultFile results(file);
  if (sweep.with_fields) check_xdmf_writable(file);
  warn_of_other_revisions(file, results.stored(), options.revisions);
  const std::vector<Request> missing =
      missing_of(wanted, results.stored(), sweep, options);
  fmt::print("{}: {} cases, {} of them to compute\n", sweep.name, wanted.keys.size(),
             missing.size());
  std::fflush(stdout);  // into a pipe, too, whatever becomes of what follows
  const SweepOutcome outcome =
      run_into(results, missing, sweep.with_fields, meshes, options.jobs, {});
  if (!outcome.count.empty()) fmt::print("computed: {}\n", counts(outcome.count));
  for (const auto& [reason, cases] : outcome.reasons)
    fmt::print("  {} {}, {}: {}\n", cases, name_of(reason.status), reason.method,
               reason.words);
  if (sweep.with_fields && !missing.empty()) write_xdmf_beside(file);
  return ExitStatus::done;
}

}  // namespace springcheck
