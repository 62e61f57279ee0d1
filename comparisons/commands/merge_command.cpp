#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "comparisons/command_line/options.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/results/result_file.hpp"

namespace springcheck {
namespace {

/// Adds to `out` the cases it lacks, with fields and meshes. A case that both have with
/// other figures is a conflict: `out` keeps its own, the difference is printed, and the
/// exit status is fell_short. What other instructions or another BLAS round otherwise is
/// told and no conflict.
ExitStatus merge(const std::filesystem::path& out,
                 const std::vector<std::filesystem::path>& from) {
  for (const std::filesystem::path& file : from) all_cases(file);  // all, or nothing
  ResultFile results(out);
  bool conflicts = false;
  for (const std::filesystem::path& file : from) {
    const auto absorbed = results.absorb(file);
    fmt::print("{}: {} {} added, {} already there\n", file.string(), absorbed.added,
               absorbed.added == 1 ? "case" : "cases", absorbed.already_there);
    if (!absorbed.roundings.empty())
      fmt::print("{} differ by rounding, kept as they were; the first: {}\n",
                 absorbed.roundings.size(), absorbed.roundings.front());
    for (const std::string& conflict : absorbed.conflicts)
      fmt::print("conflict, kept as it was: {}\n", conflict);
    conflicts |= !absorbed.conflicts.empty();
  }
  return conflicts ? ExitStatus::fell_short : ExitStatus::done;
}

Action declare_merge(CLI::App& parser) {
  struct Options {
    std::filesystem::path out{};
    std::vector<std::filesystem::path> from{};
  };
  const auto options = std::make_shared<Options>();
  add_path(parser, "out", options->out, "FILE", "HDF5 file to add to")->required();
  add_path(parser, "from", options->from, "FILE", "result files")->required();
  return [options] { return merge(options->out, options->from); };
}

}  // namespace

Command merge_command() {
  return {.name = "merge",
          .summary = "Add the cases of result files to another",
          .description = "It may be repeated: what is there already stays as it is.",
          .examples = {{"springcheck merge all.h5 first.h5 second.h5",
                        "brings the parts of a sweep together"}},
          .declare = declare_merge};
}

}  // namespace springcheck
