#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "comparisons/command_line/options.hpp"
#include "comparisons/command_line/screen.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/options/computing.hpp"
#include "comparisons/commands/options/input_options.hpp"
#include "comparisons/commands/options/interrupted.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/results/kept_results.hpp"
#include "comparisons/results/known_results.hpp"
#include "comparisons/tables/computed_tables.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

/// What is asked of a table.
struct TableOptions {
  std::string name{};
  std::vector<std::filesystem::path> from{};   // result files to take cases from
  std::optional<std::filesystem::path> out{};  // result file of all of them
  Revisions revisions = Revisions::own;        // of those that are taken
  std::string reference{};
  std::optional<TableFormat> format{};
  bool lists_tables = false;
  int threads = all_cores();
};

/// The files that cases are taken from: what `--out` keeps from before, too.
std::vector<std::filesystem::path> files_of_cases(const TableOptions& options) {
  std::vector<std::filesystem::path> files = options.from;
  const auto& out = options.out;
  if (!out) return files;
  check_results_writable(*out);
  if (!std::filesystem::exists(*out)) return files;
  const auto is_out = [&](const std::filesystem::path& file) {
    std::error_code none;
    return std::filesystem::equivalent(file, *out, none);
  };
  if (std::ranges::none_of(files, is_out)) files.push_back(*out);
  return files;
}

ExitStatus print_table(const TableOptions& options) {
  const auto& [name, of_from, out, revisions, reference, format, lists, parallel] =
      options;
  if (name.empty())
    throw InputError("springcheck table", "name", "the name of a table, or --list",
                     "neither");
  const Computing computing(parallel);
  const CatalogueEntry* const entry = &table_named(name);
  const std::vector<std::filesystem::path> from = files_of_cases(options);
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
  const BeforeInterruption told = tell_that_it_goes_on(out);
  const ComputedTables computed = compute_tables(
      {&entry, 1}, chosen, meshes, parallel, known_from(stored, meshes),
      [&](const CaseResult& result) {
        if (kept) kept->keep(result);
      },
      revisions);
  if (kept) kept->finish(computed.results, from);
  for (const Table& table : computed.tables)
    fmt::print("{}", format_table(table, format.value_or(TableFormat::markdown)));
  return ExitStatus::done;
}

ExitStatus list_tables(const std::optional<TableFormat>& format) {
  const Table tables = table_of_tables();
  fmt::print("{}", format
                       ? format_table(tables, *format)
                       : table_in_columns(tables, screen_of_output(), {"section"}) +
                             in_lines(tables.notes.front(), screen_of_output()) + "\n");
  return ExitStatus::done;
}

Action declare_table(CLI::App& parser) {
  const auto options = std::make_shared<TableOptions>();
  CLI::Option* const name =
      parser
          .add_option("name", options->name,
                      "one of those that --list tells, with the minutes that each takes")
          ->type_name("TABLE");
  CLI::Option* const from =
      add_path(parser, "--from", options->from, "FILE",
               "result files to take cases from; computes the rest");
  CLI::Option* const out = add_path(parser, "--out", options->out, "FILE",
                                    "HDF5 file for the cases behind the table; those "
                                    "that it has are not computed again")
                               ->group(of_output);
  CLI::Option* const reference =
      parser
          .add_option("--reference", options->reference,
                      "METHOD[:ELEMENT][@CELLS|@converged] for the thesis's tables")
          ->type_name("METHOD");
  add_format(parser, options->format, "md");
  CLI::Option* const list = parser.add_flag("--list", options->lists_tables,
                                            "print what tables there are instead");
  for (CLI::Option* other : {name, from, out, reference}) list->excludes(other);
  add_revisions(parser, options->revisions, "cases of the files");
  add_threads(parser, options->threads);
  return [options] {
    return options->lists_tables ? list_tables(options->format) : print_table(*options);
  };
}

}  // namespace

Command table_command() {
  return {.name = "table",
          .summary = "Print one of the thesis's tables beside ours, or one of our own",
          .description =
              "Cases that no file of --from has are computed. --out keeps them, and the "
              "next time takes them from there.",
          .examples = {{"springcheck table --list", "what tables there are"},
                       {"springcheck table 5.1",
                        "volume errors of the thesis's methods beside ours"},
                       {"springcheck table 5.3 --from results.h5 --format latex",
                        "for a paper, from cases that are computed already"}},
          .declare = declare_table};
}

}  // namespace springcheck
