#include "comparisons/commands/gate_command.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparisons/gates/gate_check.hpp"
#include "comparisons/gates/gate_file.hpp"
#include "comparisons/gates/gate_output.hpp"
#include "comparisons/results/known_results.hpp"
#include "comparisons/settings/toml_values.hpp"
#include "meshing/input_error.hpp"
#include "meshing/output_file.hpp"

namespace springcheck {
namespace {

using namespace gates;

std::vector<Outcome> judged(const std::vector<Gate>& gates, const Columns& cases,
                            const std::string& results) {
  std::vector<Outcome> outcomes;
  for (const Gate& gate : gates) outcomes.push_back(check(gate, cases, results));
  return outcomes;
}

/// Replaces stored values in the gate file and judges again by the new ones.
void bless_values(Report& report, const TomlFile& toml, const Columns& cases) {
  report.blessed = to_bless(report.gates, report.outcomes);
  if (report.blessed.empty()) return;
  const std::string text =
      with_blessed(toml.text, toml.file, report.gates, report.blessed);
  write_whole_stream(toml.file, [&](std::ostream& out) { out << text; });
  report.gates = parse_gates(text, toml.file);
  report.outcomes = judged(report.gates, cases, report.results_file);
}

}  // namespace

ExitStatus gate_command(const std::string& name_or_path,
                        const std::filesystem::path& results,
                        const std::optional<std::filesystem::path>& junit, Output output,
                        Bless bless, Revisions revisions) {
  if (bless == Bless::yes && !is_toml_path(name_or_path))
    throw InputError("--bless", "", "a path to a gate file",
                     "'" + name_or_path + "', which is part of the program");
  const TomlFile toml = toml_file(name_or_path, "gate", shipped_gates());
  const std::vector<Gate> parsed = parse_gates(toml.text, toml.file);
  if (bless == Bless::yes) check_writable(toml.file);
  if (junit) {
    check_writable(*junit);
    for (const std::filesystem::path& input : {results, std::filesystem::path(toml.file)})
      if (std::error_code none; std::filesystem::equivalent(*junit, input, none))
        throw InputError("--junit", "", "another file than " + input.string(),
                         "'" + junit->string() + "'");
  }
  if (bless == Bless::yes && revisions == Revisions::all)
    throw InputError("--bless", "", "figures of this program's revision alone",
                     "--accept-other-revisions");
  const Columns cases = read_cases(results, revisions);
  const StoredKeys stored = stored_keys(results);

  Report report{.gates_name = toml.name,
                .gates_file = toml.file,
                .results_file = results.string(),
                .gates = parsed,
                .outcomes = judged(parsed, cases, results.string()),
                .others = stored.others,
                .revisions = revisions,
                .note = note_of_other_revisions(stored, revisions)};
  if (bless == Bless::yes) bless_values(report, toml, cases);
  if (junit)
    write_whole_stream(*junit, [&](std::ostream& out) { write_junit(out, report); });
  if (output == Output::json)
    fmt::print("{}\n", report_json(report).dump(
                           2, ' ', false, nlohmann::json::error_handler_t::replace));
  else
    fmt::print("{}", report_text(report));

  if (count(report, Judgement::no_case) > 0) return ExitStatus::bad_input;
  return count(report, Judgement::falls_short) > 0 ? ExitStatus::fell_short
                                                   : ExitStatus::done;
}

}  // namespace springcheck
