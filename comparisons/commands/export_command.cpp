#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "comparisons/command_line/options.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/options/input_options.hpp"
#include "comparisons/formats/parquet.hpp"
#include "comparisons/formats/text_table.hpp"
#include "comparisons/results/case_table.hpp"
#include "comparisons/results/known_results.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/output_file.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;
using Texts = std::vector<std::string>;
using Numbers = std::vector<double>;
using CaseTable = std::vector<CaseColumn>;

std::string heading(const CaseColumn& column) {
  return column.unit.empty() ? column.name
                             : fmt::format("{} [{}]", column.name, column.unit);
}

std::size_t size_of(const CaseColumn& column) {
  return std::visit([](const auto& values) { return values.size(); }, column.values);
}

/// A column's value in a row, to all digits; empty where there is none.
std::string text_at(const CaseColumn& column, std::size_t row) {
  if (const auto* texts = std::get_if<Texts>(&column.values)) return (*texts)[row];
  const double value = std::get<Numbers>(column.values)[row];
  return std::isnan(value) ? "" : fmt::format("{}", value);
}
Json json_at(const CaseColumn& column, std::size_t row) {
  const std::string text = text_at(column, row);
  if (text.empty()) return {};
  const auto* numbers = std::get_if<Numbers>(&column.values);
  return numbers == nullptr ? Json(text) : Json((*numbers)[row]);
}

void write_csv(std::ostream& out, const CaseTable& table) {
  TextLines lines(1 + size_of(table.front()));
  for (const CaseColumn& column : table) {
    lines.front().push_back(heading(column));
    for (std::size_t row = 0; row + 1 < lines.size(); ++row)
      lines[row + 1].push_back(text_at(column, row));
  }
  out << csv_text(lines);
}

void write_json(std::ostream& out, const CaseTable& table) {
  Json columns = Json::array(), cases = Json::array();
  for (const CaseColumn& column : table)
    columns.push_back({{"name", column.name}, {"unit", column.unit}});
  for (std::size_t row = 0; row < size_of(table.front()); ++row) {
    Json one = Json::object();
    for (const CaseColumn& column : table) one[column.name] = json_at(column, row);
    cases.push_back(std::move(one));
  }
  out << Json{{"columns", columns}, {"cases", cases}}.dump(1) << "\n";
}

void write_as_parquet(std::ostream& out, const CaseTable& table) {
  std::vector<ParquetColumn> columns;
  for (const CaseColumn& column : table)
    columns.push_back({heading(column), column.values});
  write_parquet(out, columns);
}

struct Format {
  std::string_view extension;
  void (*write)(std::ostream&, const CaseTable&);
};
constexpr Format formats[] = {
    {".csv", write_csv}, {".parquet", write_as_parquet}, {".json", write_json}};

const Format& format_of(const std::filesystem::path& out) {
  for (const Format& format : formats)
    if (out.extension() == format.extension) return format;
  throw InputError("--out", "", "a file named .csv, .parquet or .json",
                   "'" + out.string() + "'");
}

/// What is asked of an export.
///
///     .csv      RFC 4180; the head has units, "plate_force_norm [N]"
///     .parquet  Apache Parquet; the same names, with nulls
///     .json     {"columns": [{"name", "unit"}], "cases": [{name: value}]}
struct ExportOptions {
  std::filesystem::path results{};
  std::filesystem::path out{};
  std::vector<std::string> columns{};  // see case_table; empty: what differs
  Revisions revisions = Revisions::own;
};

ExitStatus write_cases(const ExportOptions& options) {
  const auto& [results, out, columns, revisions] = options;
  const Format& format = format_of(out);
  check_writable(out);
  const Columns cases = read_cases(results, revisions);
  const StoredKeys stored = stored_keys(results);
  if (cases.rows == 0)
    throw InputError(
        results.string(), "", "cases",
        stored.others.empty() ? "none" : note_of_other_revisions(stored, revisions));
  warn_of_other_revisions(results, stored, revisions);
  const CaseTable table = case_table(cases, columns);
  write_whole_stream(out, [&](std::ostream& stream) { format.write(stream, table); });
  fmt::print("{}: {} cases, {} columns\n", out.string(), cases.rows, table.size());
  return ExitStatus::done;
}

Action declare_export(CLI::App& parser) {
  const auto options = std::make_shared<ExportOptions>();
  add_results(parser, options->results);
  add_path(parser, "--out", options->out, "FILE", "a .csv, .parquet or .json file")
      ->required()
      ->group(of_output);
  parser
      .add_option("--columns", options->columns,
                  "settings, measures and columns of 'springcheck list columns', with "
                  "commas between (default: what differs between cases, and what was "
                  "measured)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("SETTING|MEASURE|COLUMN")
      ->group(of_output);
  add_revisions(parser, options->revisions, "cases in the file");
  return [options] { return write_cases(*options); };
}

}  // namespace

Command export_command() {
  return {.name = "export",
          .summary = "Write the cases of a result file as a table for other programs",
          .description = "",
          .examples = {{"springcheck export results.h5 --out cases.csv", "every case"},
                       {"springcheck export results.h5 --out cases.parquet --columns "
                        "method,nu,volume_error",
                        "some columns, for pandas or R"}},
          .declare = declare_export};
}

}  // namespace springcheck
