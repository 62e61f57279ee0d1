#include "comparisons/gates/gate_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/formats/text_table.hpp"

namespace springcheck::gates {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const Gate& gate, const Outcome& outcome) {
  return {{"name", gate.name},
          {"verdict", name_of(outcome.verdict)},
          {"measure", gate.measure.empty() ? "status" : gate.measure},
          {"got", number_or_null(outcome.got)},
          {"values", outcome.values},
          {"band",
           {{"low", number_or_null(outcome.band.low)},
            {"high", number_or_null(outcome.band.high)},
            {"text", outcome.band_text}}},
          {"margin", number_or_null(outcome.margin)},
          {"explanation", outcome.explanation},
          {"reason", gate.reason},
          {"where", text_of(gate.where)},
          {"keys", outcome.keys},
          {"place", gate.place}};
}

/// XML 1.0 has no place for control characters, however they are written.
std::string xml_text(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t') c = '?';
  return text;
}

std::string why(const Gate& gate, const Outcome& outcome) {
  return fmt::format("{}: got {}, band {}: {}",
                     gate.measure.empty() ? "status" : gate.measure, outcome.got_text,
                     outcome.band_text, outcome.explanation);
}

}  // namespace

std::size_t count(const Report& report, Judgement verdict) {
  return static_cast<std::size_t>(
      std::ranges::count(report.outcomes, verdict, &Outcome::verdict));
}

Table report_table(const Report& report) {
  Table table{
      .name = "gates",
      .title = fmt::format("Gates of {} on {}", report.gates_file, report.results_file),
      .columns = {{.key = "gate", .heading = "gate"},
                  {.key = "got", .heading = "got"},
                  {.key = "band", .heading = "band"},
                  {.key = "margin", .heading = "margin", .format = "{:.2f}"},
                  {.key = "verdict", .heading = "verdict"}}};
  for (std::size_t i = 0; i < report.gates.size(); ++i) {
    const Gate& gate = report.gates[i];
    const Outcome& outcome = report.outcomes[i];
    TableRow row{.cells = {gate.name, outcome.got_text, outcome.band_text,
                           Cell(outcome.margin, "-"), name_of(outcome.verdict)},
                 .cases = outcome.keys};
    if (outcome.verdict != Judgement::pass)
      row.notes.push_back(
          fmt::format("{}: {}.{}", gate.place, outcome.explanation,
                      outcome.verdict == Judgement::falls_short
                          ? fmt::format(" Reason of the band: {}.", gate.reason)
                          : ""));
    table.rows.push_back(std::move(row));
  }
  if (!report.note.empty())
    table.notes.push_back(fmt::format("{}: {}", report.results_file, report.note));
  table.notes.push_back(fmt::format("Margin: {}.", margin_definition));
  return table;
}

std::string report_text(const Report& report, const Screen& screen) {
  std::string text, below;
  const auto add = [&](const std::string& line) {
    below += in_lines(line, screen) + "\n";
  };
  for (const Blessed& value : report.blessed) {
    const Gate& gate = report.gates[value.gate];
    text +=
        fmt::format("blessed {}: {} -> {} ({})\n", gate.name, described(value.old_value),
                    described(value.new_value), gate.place);
  }
  if (!text.empty()) text += "\n";
  for (std::size_t i = 0; i < report.gates.size(); ++i) {
    const Gate& gate = report.gates[i];
    const Outcome& outcome = report.outcomes[i];
    if (outcome.verdict != Judgement::pass)
      add(fmt::format("{}: {}: {}", gate.place, gate.name, outcome.explanation));
    if (outcome.verdict == Judgement::falls_short)
      add(fmt::format("  reason of the band: {}", gate.reason));
  }
  text += table_in_columns(report_table(report), screen);
  if (!below.empty()) text += "\n" + below;
  if (!report.note.empty())
    text += "\n" + in_lines(report.results_file + ": " + report.note, screen) + "\n";
  return text +
         fmt::format("\n{}\n{}\n",
                     in_lines(fmt::format("{} gates of {}: {} pass, {} fall short, {} "
                                          "without a case",
                                          report.gates.size(), report.gates_file,
                                          count(report, Judgement::pass),
                                          count(report, Judgement::falls_short),
                                          count(report, Judgement::no_case)),
                              screen),
                     in_lines(fmt::format("margin: {}", margin_definition), screen));
}

nlohmann::ordered_json report_json(const Report& report) {
  Json verdicts = Json::array(), blessed = Json::array();
  for (std::size_t i = 0; i < report.gates.size(); ++i)
    verdicts.push_back(json_of(report.gates[i], report.outcomes[i]));
  for (const Blessed& value : report.blessed)
    blessed.push_back({{"name", report.gates[value.gate].name},
                       {"old", value.old_value},
                       {"new", value.new_value}});
  return {{"springcheck", build_info::version},
          {"gates", report.gates_file},
          {"results", report.results_file},
          {"pass", count(report, Judgement::pass)},
          {"fall_short", count(report, Judgement::falls_short)},
          {"no_case", count(report, Judgement::no_case)},
          {"margin", margin_definition},
          {"blessed", blessed},
          {"other_revisions", Json(report.others)},
          {"accepts_other_revisions", report.revisions == Revisions::all},
          {"verdicts", verdicts}};
}

void write_junit(std::ostream& out, const Report& report) {
  pugi::xml_document document;
  pugi::xml_node suite = document.append_child("testsuites").append_child("testsuite");
  const auto set = [](pugi::xml_node element, const char* name,
                      const std::string& value) {
    element.append_attribute(name).set_value(xml_text(value).c_str());
  };
  set(suite, "name", report.gates_name);
  set(suite, "tests", fmt::to_string(report.gates.size()));
  set(suite, "failures", fmt::to_string(count(report, Judgement::falls_short)));
  set(suite, "errors", fmt::to_string(count(report, Judgement::no_case)));
  if (!report.note.empty()) {
    const pugi::xml_node property =
        suite.append_child("properties").append_child("property");
    set(property, "name", "other revisions");
    set(property, "value", report.results_file + ": " + report.note);
  }
  for (std::size_t i = 0; i < report.gates.size(); ++i) {
    const Gate& gate = report.gates[i];
    const Outcome& outcome = report.outcomes[i];
    pugi::xml_node test = suite.append_child("testcase");
    set(test, "classname", "springcheck." + report.gates_name);
    set(test, "name", gate.name);
    if (outcome.verdict == Judgement::pass) continue;
    const bool is_short = outcome.verdict == Judgement::falls_short;
    const pugi::xml_node failure = test.append_child(is_short ? "failure" : "error");
    set(failure, "type", std::string(name_of(outcome.verdict)));
    set(failure, "message", why(gate, outcome));
    failure.text().set(xml_text(fmt::format("{}\nwhere {}\nreason of the band: {}",
                                            gate.place, text_of(gate.where), gate.reason))
                           .c_str());
  }
  document.save(out, "  ");
}

}  // namespace springcheck::gates
