#include <CLI/CLI.hpp>
#include <memory>

#include "comparisons/command_line/options.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/options/computing.hpp"
#include "comparisons/commands/options/interrupted.hpp"
#include "comparisons/commands/reproduce.hpp"

namespace springcheck {
namespace {

Action declare_reproduce(CLI::App& parser) {
  struct Options {
    std::filesystem::path out{};
    Extent extent = Extent::without_long_tables;
    int threads = all_cores();
  };
  const auto options = std::make_shared<Options>();
  add_path(parser, "--out", options->out, "FOLDER",
           "folder for page, tables, results and summary")
      ->required();
  CLI::Option* const all = parser.add_flag_callback(
      "--all", [options] { options->extent = Extent::all; },
      "the tables of ten minutes and more too, most of an hour");
  parser
      .add_flag_callback(
          "--quick", [options] { options->extent = Extent::quick; },
          "the thesis's five tests alone, in two minutes")
      ->excludes(all);
  add_threads(parser, options->threads);
  return [options] {
    const Computing computing(options->threads);
    const BeforeInterruption kept = tell_that_it_goes_on(options->out / "results.h5");
    return reproduce(options->out, options->extent, options->threads);
  };
}

}  // namespace

Command reproduce_command() {
  return {.name = "reproduce",
          .summary = "Regenerate every table and the page",
          .description =
              "What was computed is kept, whatever ends the command: started "
              "again, it goes on.",
          .examples = {{"springcheck reproduce --quick --out thesis",
                        "the thesis's five tests and their page, in two minutes"},
                       {"springcheck reproduce --out everything",
                        "tables, sweeps, charts, a map and the page, in a quarter of an "
                        "hour on two cores"}},
          .declare = declare_reproduce};
}

}  // namespace springcheck
