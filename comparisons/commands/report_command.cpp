#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/command_line/options.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/options/input_options.hpp"
#include "comparisons/report/report.hpp"
#include "comparisons/results/known_results.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

/// Throws InputError before anything is written.
ExitStatus report(const std::filesystem::path& file, const std::filesystem::path& folder,
                  Revisions revisions) {
  if (std::filesystem::exists(file) && !std::filesystem::is_regular_file(file))
    throw InputError(file.string(), "", "a result file", "what is no file");
  // Whatever is wrong with the file is said before a folder is made.
  const bool is_empty = read_results(file, revisions).empty();
  const StoredKeys stored = stored_keys(file);
  if (is_empty && !stored.others.empty())
    throw InputError(file.string(), "",
                     fmt::format("cases of revision {}", build_info::revision),
                     note_of_other_revisions(stored, revisions));
  prepare_report(folder);
  return make_report(file, folder, {}, revisions);
}

Action declare_report(CLI::App& parser) {
  struct Options {
    std::filesystem::path results{}, out{};
    Revisions revisions = Revisions::own;
  };
  const auto options = std::make_shared<Options>();
  add_results(parser, options->results);
  add_path(parser, "--out", options->out, "FOLDER", "folder for them")->required();
  add_revisions(parser, options->revisions, "cases in the file");
  return [options] { return report(options->results, options->out, options->revisions); };
}

}  // namespace

Command report_command() {
  return {.name = "report",
          .summary = "Make page, figures and tables of a result file",
          .description = "Computes nothing. index.html in the folder is where to start.",
          .examples = {{"springcheck report results.h5 --out page",
                        "page/index.html, with figures and tables beside it"}},
          .declare = declare_report};
}

}  // namespace springcheck
