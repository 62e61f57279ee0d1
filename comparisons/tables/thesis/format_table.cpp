#include "comparisons/tables/thesis/format_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/sheets/latex_table.hpp"
#include "comparisons/sheets/text_table.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

enum class Digits { rounded, all };

std::string number(const Quantity& quantity, const std::optional<double>& value,
                   Digits digits) {
  if (!value) return {};
  if (digits == Digits::all) return fmt::format("{}", *value);
  return rounded(quantity.format, *value);
}

std::string plain(const std::optional<double>& value, const char* format, Digits digits) {
  if (!value) return {};
  return digits == Digits::all ? fmt::format("{}", *value) : rounded(format, *value);
}

std::string signed_number(const Quantity& quantity, const std::optional<double>& value,
                          Digits digits) {
  const std::string text = number(quantity, value, digits);
  return text.empty() || text.starts_with('-') ? text : "+" + text;
}

std::string heading(const Quantity& quantity) {
  return quantity.unit == "-" ? quantity.name
                              : fmt::format("{} [{}]", quantity.name, quantity.unit);
}

/// What stands where a value is missing: the status and how far the load was carried.
std::string instead_of_value(const CaseResult& result) {
  const double fraction = result.solution.load_fraction;
  const std::string_view status = name_of(result.status);
  const CaseSettings& settings = result.request.settings;
  if (fraction == 0 || !settings.deformation) return std::string(status);
  const double reached = fraction * *settings.deformation;
  return entry_of(settings.test).turns
             ? fmt::format("{} beyond {:.3g} deg", status,
                           reached * 180 / std::numbers::pi)
             : fmt::format("{} beyond {:.3g} %", status, 100 * reached);
}

std::string statuses(const CaseResult& result) {
  if (result.flags.size() < 2) return std::string(name_of(result.status));
  std::vector<std::string_view> names;
  for (const Status flag : result.flags) names.push_back(name_of(flag));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string reference_of(const CaseResult& result) {
  return result.request.reference ? reference_label(result.request) : "itself";
}

/// All footnotes of the table: on the whole first, then the rows', each once.
std::vector<std::string> footnotes(const Table& table) {
  std::vector<std::string> notes;
  for (const TableRow& row : table.rows)
    for (const std::string& note : row.plan.notes)
      if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
  return notes;
}

std::string note_marks(const TableRow& row, const std::vector<std::string>& notes) {
  std::vector<std::ptrdiff_t> marks;
  for (const std::string& note : row.plan.notes)
    marks.push_back(std::ranges::find(notes, note) - notes.begin() + 1);
  return fmt::format("{}", fmt::join(marks, " "));
}

std::vector<std::string> headings(const Table& table) {
  const Quantity& quantity = table.plan.quantity;
  const std::string unit =
      quantity.unit == "-"
          ? ""
          : fmt::format(" [{}]", quantity.unit == "%" ? "points" : quantity.unit);
  std::vector<std::string> all = table.plan.label_headings;
  all.insert(all.end(), {"printed " + heading(quantity), "ours " + heading(quantity),
                         "ours - printed" + unit, "reference's " + heading(quantity),
                         "reference's +-", "reference's order", "reference", "mesh",
                         "printed instabilities", "status"});
  for (const Quantity& further : table.plan.further) all.push_back(heading(further));
  all.insert(all.end(), {"notes", "case"});
  return all;
}

std::vector<std::string> cells(const Table& table, const TableRow& row,
                               const std::vector<std::string>& notes, Digits digits) {
  const Quantity& quantity = table.plan.quantity;
  std::vector<std::string> all = row.plan.labels;
  all.insert(
      all.end(),
      {row.plan.printed_text,
       row.ours ? number(quantity, row.ours, digits) : instead_of_value(row.result),
       signed_number(quantity, row.difference, digits),
       number(quantity, row.reference_value, digits),
       plain(row.reference_bar, "{:.1g}", digits),
       plain(row.reference_order, "{:.2f}", digits), reference_of(row.result),
       fmt::format("{}", fmt::join(row.result.request.settings.body.block.cells, "x")),
       row.plan.verdict, statuses(row.result)});
  for (std::size_t i = 0; i < table.plan.further.size(); ++i)
    all.push_back(number(table.plan.further[i], row.further[i], digits));
  all.insert(all.end(), {note_marks(row, notes), row.result.key.substr(0, 12)});
  return all;
}

/// Heads and rows, without the columns that are empty in every row.
std::vector<std::vector<std::string>> grid(const Table& table,
                                           const std::vector<std::string>& notes) {
  std::vector<std::vector<std::string>> lines{headings(table)};
  for (const TableRow& row : table.rows)
    lines.push_back(cells(table, row, notes, Digits::rounded));
  return without_empty_columns(std::move(lines));
}

/// What tables to be read say below their rows.
TableText text_of(const Table& table, const std::vector<std::string>& notes) {
  std::vector<std::string> on_the_table{
      "Reference: the solution (method:element, on the same mesh unless @ says "
      "otherwise) "
      "that deviations and the columns \"reference's\" belong to; with @converged, its "
      "error "
      "bar (+-) and the order observed."};
  on_the_table.insert(on_the_table.end(), table.plan.notes.begin(),
                      table.plan.notes.end());
  return {.title = table.plan.title, .notes = on_the_table, .footnotes = notes};
}

/// The same without what only the screen has room for: further measures beside printed
/// values.
std::vector<std::vector<std::string>> narrow_grid(const Table& table,
                                                  const std::vector<std::string>& notes) {
  Table narrow = table;
  const bool has_printed = std::ranges::any_of(
      table.rows, [](const TableRow& row) { return row.plan.printed.has_value(); });
  if (has_printed) narrow.plan.further.clear();
  return grid(narrow, notes);
}

/// All digits, and the notes in words.
std::string csv(const Table& table) {
  const std::vector<std::string> notes = footnotes(table);
  std::vector<std::vector<std::string>> lines{headings(table)};
  for (const TableRow& row : table.rows) {
    lines.push_back(cells(table, row, notes, Digits::all));
    lines.back().end()[-2] = fmt::format("{}", fmt::join(row.plan.notes, " "));
    lines.back().back() = row.result.key;
  }
  return csv_text(lines);
}

Json json(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

std::string json_text(const Table& table) {
  Json rows = Json::array();
  for (const TableRow& row : table.rows) {
    Json out;
    for (std::size_t i = 0; i < row.plan.labels.size(); ++i)
      out[table.plan.label_headings[i]] = row.plan.labels[i];
    Json flags = Json::array();
    for (const Status flag : row.result.flags) flags.push_back(name_of(flag));
    out["printed"] = json(row.plan.printed);
    out["printed_text"] =
        row.plan.printed_text.empty() ? Json() : Json(row.plan.printed_text);
    out["ours"] = json(row.ours);
    out["difference"] = json(row.difference);
    out["reference_value"] = json(row.reference_value);
    out["reference_bar"] = json(row.reference_bar);
    out["reference_order"] = json(row.reference_order);
    out["reference"] =
        row.result.request.reference ? Json(reference_label(row.result.request)) : Json();
    out["cells"] = row.result.request.settings.body.block.cells;
    out["printed_instabilities"] =
        row.plan.verdict.empty() ? Json() : Json(row.plan.verdict);
    out["status"] = name_of(row.result.status);
    out["flags"] = flags;
    out["reason"] = row.result.reason.empty() ? Json() : Json(row.result.reason);
    out["load_fraction"] = row.result.solution.load_fraction;
    for (std::size_t i = 0; i < table.plan.further.size(); ++i)
      out[heading(table.plan.further[i])] = json(row.further[i]);
    out["notes"] = row.plan.notes;
    out["case"] = row.result.key;
    rows.push_back(out);
  }
  Json further = Json::array();
  for (const Quantity& quantity : table.plan.further)
    further.push_back({{"key", heading(quantity)}, {"format", quantity.format}});
  const Json document{{"springcheck", build_info::version},
                      {"table", table.plan.name},
                      {"title", table.plan.title},
                      {"labels", table.plan.label_headings},
                      {"quantity", table.plan.quantity.name},
                      {"unit", table.plan.quantity.unit},
                      {"format", table.plan.quantity.format},
                      {"further", further},
                      {"rows", rows},
                      {"notes", table.plan.notes}};
  return document.dump(2) + "\n";
}

}  // namespace

std::string format_table(const Table& table, TableFormat format) {
  const std::vector<std::string> notes = footnotes(table);
  switch (format) {
    case TableFormat::markdown:
      return markdown_text(grid(table, notes), text_of(table, notes));
    case TableFormat::latex:
      return latex_text(narrow_grid(table, notes), text_of(table, notes));
    case TableFormat::csv:
      return csv(table);
    case TableFormat::json:
      return json_text(table);
  }
  return {};
}

}  // namespace springcheck
