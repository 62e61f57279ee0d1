#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "comparisons/formats/table.hpp"
#include "comparisons/gates/bless.hpp"
#include "comparisons/gates/gate.hpp"
#include "comparisons/gates/outcome.hpp"
#include "comparisons/results/known_results.hpp"

namespace springcheck::gates {

/// Gates, what came of each, and whose they are.
struct Report {
  std::string gates_name;  // "accuracy"
  std::string gates_file;  // as messages name it
  std::string results_file;
  std::vector<Gate> gates;
  std::vector<Outcome> outcomes;
  std::vector<Blessed> blessed{};  // what --bless replaced before they were judged
  OtherRevisions others{};         // in the file
  Revisions revisions = Revisions::own;
  std::string note{};  // see note_of_other_revisions
};

std::size_t count(const Report& report, Judgement verdict);

/// The table of a report: a row for each gate, with a note on why it does not pass.
Table report_table(const Report& report);

/// The gates and what came of each as text for a screen, and below why some do not pass.
std::string report_text(const Report& report, const Screen& screen = {});

/// The report as one document; the README has its fields.
nlohmann::ordered_json report_json(const Report& report);

/// The JSON schema of report_json().
nlohmann::ordered_json report_schema();

/// JUnit XML, as continuous integration reads it: a gate that falls short is a failure,
/// one without a case an error.
void write_junit(std::ostream& out, const Report& report);

}  // namespace springcheck::gates
