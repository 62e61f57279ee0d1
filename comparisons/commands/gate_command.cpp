#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "comparisons/command_line/options.hpp"
#include "comparisons/command_line/screen.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/options/input_options.hpp"
#include "comparisons/gates/gate_check.hpp"
#include "comparisons/gates/gate_file.hpp"
#include "comparisons/gates/gate_output.hpp"
#include "comparisons/results/known_results.hpp"
#include "comparisons/settings/toml_values.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/output_file.hpp"

namespace springcheck {
namespace {

Colour colour_of_verdicts(std::string_view head, std::string_view cell) {
  if (head != "verdict") return Colour::usual;
  const auto* const verdict = find_value<gates::Judgement>(cell);
  if (verdict == nullptr) return Colour::usual;
  return verdict->value == gates::Judgement::pass      ? Colour::good
         : verdict->value == gates::Judgement::no_case ? Colour::doubtful
                                                       : Colour::bad;
}

std::vector<gates::Outcome> judged(const std::vector<gates::Gate>& all,
                                   const Columns& cases, const std::string& results) {
  std::vector<gates::Outcome> outcomes;
  for (const gates::Gate& gate : all) outcomes.push_back(check(gate, cases, results));
  return outcomes;
}

/// Replaces stored values in the gate file and judges again by the new ones.
void bless_values(gates::Report& report, const TomlFile& toml, const Columns& cases) {
  report.blessed = to_bless(report.gates, report.outcomes);
  if (report.blessed.empty()) return;
  const std::string text =
      with_blessed(toml.text, toml.file, report.gates, report.blessed);
  write_whole_stream(toml.file, [&](std::ostream& out) { out << text; });
  report.gates = gates::parse_gates(text, toml.file);
  report.outcomes = judged(report.gates, cases, report.results_file);
}

struct GateOptions {
  std::string gates{};  // a file's name, or that of a shipped one
  std::filesystem::path results{};
  std::optional<std::filesystem::path> junit{};
  std::optional<TableFormat> format{};
  bool blesses = false;
  Revisions revisions = Revisions::own;
};

/// done when all pass, fell_short when one does not, bad_input when one has no case.
ExitStatus judge(const GateOptions& options) {
  if (options.blesses && !is_toml_path(options.gates))
    throw InputError("--bless", "", "a path to a gate file",
                     "'" + options.gates + "', which is part of the program");
  const TomlFile toml = toml_file(options.gates, a_gate_file);
  const std::vector<gates::Gate> parsed = gates::parse_gates(toml.text, toml.file);
  if (options.blesses) check_writable(toml.file);
  if (options.junit) {
    check_writable(*options.junit);
    for (const std::filesystem::path& input :
         {options.results, std::filesystem::path(toml.file)})
      if (std::error_code none; std::filesystem::equivalent(*options.junit, input, none))
        throw InputError("--junit", "", "another file than " + input.string(),
                         "'" + options.junit->string() + "'");
  }
  if (options.blesses && options.revisions == Revisions::all)
    throw InputError("--bless", "", "figures of this program's revision alone",
                     "--accept-other-revisions");
  const Columns cases = read_cases(options.results, options.revisions);
  const StoredKeys stored = stored_keys(options.results);

  gates::Report report{.gates_name = toml.name,
                       .gates_file = toml.file,
                       .results_file = options.results.string(),
                       .gates = parsed,
                       .outcomes = judged(parsed, cases, options.results.string()),
                       .others = stored.others,
                       .revisions = options.revisions,
                       .note = note_of_other_revisions(stored, options.revisions)};
  if (options.blesses) bless_values(report, toml, cases);
  if (options.junit)
    write_whole_stream(*options.junit,
                       [&](std::ostream& out) { write_junit(out, report); });
  if (options.format == TableFormat::json)
    fmt::print("{}\n", report_json(report).dump(
                           2, ' ', false, nlohmann::json::error_handler_t::replace));
  else if (options.format)
    fmt::print("{}", format_table(report_table(report), *options.format));
  else
    fmt::print("{}", report_text(report, screen_of_output(colour_of_verdicts)));

  if (count(report, gates::Judgement::no_case) > 0) return ExitStatus::bad_input;
  return count(report, gates::Judgement::falls_short) > 0 ? ExitStatus::fell_short
                                                          : ExitStatus::done;
}

Action declare_gate(CLI::App& parser) {
  const auto options = std::make_shared<GateOptions>();
  parser
      .add_option("gates", options->gates, "a gate file (.toml), or accuracy or thesis")
      ->required()
      ->type_name("accuracy|thesis|FILE");
  add_results(parser, options->results);
  add_path(parser, "--junit", options->junit, "FILE", "JUnit XML file to write")
      ->group(of_output);
  add_formats(parser, options->format);
  parser.add_flag("--bless", options->blesses,
                  "replace stored values that are outside their bands in the gate file");
  add_revisions(parser, options->revisions, "cases in the file");
  return [options] { return judge(*options); };
}

}  // namespace

Command gate_command() {
  return {.name = "gate",
          .summary = "Judge results by bands, as a CI does",
          .description = "",
          .examples = {{"springcheck gate thesis results.h5",
                        "whether the figures are those of the thesis"},
                       {"springcheck gate bands.toml results.h5 --junit gates.xml",
                        "by bands of your own, for a CI that reads JUnit"}},
          .declare = declare_gate};
}

}  // namespace springcheck
