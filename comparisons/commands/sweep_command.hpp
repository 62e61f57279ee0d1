#pragma once

#include <filesystem>
#include <string>

#include "comparisons/commands/commands.hpp"

namespace springcheck {

struct SweepOptions {
  int jobs;                   // simulations at once, at most
  bool dry_run = false;       // count and estimate only
  bool only_failed = false;   // those the file holds with a status other than ok
  bool recompute = false;     // also what the file holds
  bool yes = false;           // more than a million combinations are meant
  int shard = 1, shards = 1;  // every shards-th case, from the shard-th on
  Revisions revisions = Revisions::own;
};

/// "I/N". Throws InputError unless 1 <= I <= N.
void set_shard(SweepOptions& options, const std::string& text);

/// `springcheck sweep`: computes the cases the result file lacks and adds each as soon as
/// it is complete.
ExitStatus sweep_command(const std::string& name_or_path,
                         const std::filesystem::path& file, const SweepOptions& options);

/// `springcheck merge`: adds to `out` the cases it lacks, with fields and meshes. A case
/// that both have with other figures is a conflict: `out` keeps its own, the difference
/// is printed, and the exit status is fell_short. What other instructions or another BLAS
/// round otherwise is told and no conflict.
ExitStatus merge_command(const std::filesystem::path& out,
                         const std::vector<std::filesystem::path>& from);

}  // namespace springcheck
