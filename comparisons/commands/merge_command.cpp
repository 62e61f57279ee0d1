#include <fmt/format.h>

#include "comparisons/commands/sweep_command.hpp"
#include "comparisons/results/result_file.hpp"

namespace springcheck {

ExitStatus merge_command(const std::filesystem::path& out,
                         const std::vector<std::filesystem::path>& from) {
  for (const std::filesystem::path& file : from) all_cases(file);  // all, or nothing
  ResultFile results(out);
  bool conflicts = false;
  for (const std::filesystem::path& file : from) {
    const auto absorbed = results.absorb(file);
    fmt::print("{}: {} cases added, {} already there\n", file.string(), absorbed.added,
               absorbed.already_there);
    if (!absorbed.roundings.empty())
      fmt::print("{} differ by rounding, kept as they were; the first: {}\n",
                 absorbed.roundings.size(), absorbed.roundings.front());
    for (const std::string& conflict : absorbed.conflicts)
      fmt::print("conflict, kept as it was: {}\n", conflict);
    conflicts |= !absorbed.conflicts.empty();
  }
  return conflicts ? ExitStatus::fell_short : ExitStatus::done;
}

}  // namespace springcheck
