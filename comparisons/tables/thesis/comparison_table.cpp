#include "comparisons/tables/thesis/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

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

std::string reference_of(const CaseResult& result) {
  return result.request.reference ? reference_label(result.request) : "itself";
}

/// The name of a row: "nu 0, deformation 5 %, method mss-cf".
std::string row_name(const Comparison& comparison, const ComparisonRow& row) {
  std::string name;
  for (std::size_t i = 0; i < row.plan.labels.size(); ++i)
    name += fmt::format("{}{} {}", i == 0 ? "" : ", ", comparison.plan.label_headings[i],
                        row.plan.labels[i]);
  return name;
}

/// The row of a method that is furthest from its printed value, relative to it or, for
/// printed percentages, in points. Empty when none has a printed value.
std::string worst_against_thesis(const Comparison& comparison,
                                 const std::string& method) {
  const bool points = comparison.plan.quantity.unit == "%";
  const ComparisonRow* worst = nullptr;
  double largest = -1;
  int compared = 0;
  for (const ComparisonRow& row : comparison.rows) {
    if (row.result.request.settings.method.name != method || !row.difference) continue;
    ++compared;
    const double size = points ? std::abs(*row.difference)
                               : std::abs(*row.difference / *row.plan.printed);
    if (size > largest) {
      largest = size;
      worst = &row;
    }
  }
  if (worst == nullptr) return {};
  return fmt::format(
      "{} {} rows; furthest from print: {} ({}){}", compared, method,
      row_name(comparison, *worst),
      points ? fmt::format("{:+.2f} points", *worst->difference)
             : fmt::format("{:+.1f} %", 100 * *worst->difference / *worst->plan.printed),
      worst->plan.notes.empty() ? "" : ": see its notes in the table");
}

/// How far mss-cf is from the thesis's own, and from its FEM column the law nearest to
/// that.
std::string against_thesis(const Comparison& comparison) {
  std::string text = worst_against_thesis(comparison, "mss-cf");
  if (text.empty()) return "no printed figure of mss-cf to compare with";
  const std::string fem = worst_against_thesis(comparison, "fem-hencky");
  return fem.empty() ? text : text + "; " + fem;
}

std::vector<Column> columns_of(const ComparisonPlan& plan) {
  const auto& [labels, quantity, further, rows, notes] = plan;
  const std::string shown = heading(quantity), format(quantity.format);
  const std::string unit =
      quantity.unit == "-"
          ? ""
          : fmt::format(" [{}]", quantity.unit == "%" ? "points" : quantity.unit);
  std::vector<Column> columns;
  for (const std::string& label : labels) columns.push_back({label, label});
  columns.insert(columns.end(), {{"printed_text", "printed " + shown},
                                 {"ours", "ours " + shown, format},
                                 {"difference", "ours - printed" + unit, format, true},
                                 {"reference_value", "reference's " + shown, format},
                                 {"reference_bar", "reference's +-", "{:.1g}"},
                                 {"reference_order", "reference's order", "{:.2f}"},
                                 {"reference", "reference"},
                                 {"mesh", "mesh"},
                                 {"printed_instabilities", "printed instabilities"},
                                 {"status", "status"}});
  // Beside printed values print has no room for further measures.
  const bool is_printed = std::ranges::any_of(
      rows, [](const PlannedRow& row) { return row.printed.has_value(); });
  for (const Quantity& one : further)
    columns.push_back({.key = heading(one),
                       .heading = heading(one),
                       .format = std::string(one.format),
                       .in_print = !is_printed});
  return columns;
}

Json json(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json json(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

/// What JSON tells besides the columns, or by one word where tables to be read have
/// several.
Json json_of(const ComparisonRow& row) {
  const CaseResult& result = row.result;
  Json flags = Json::array();
  for (const Status flag : result.flags) flags.push_back(name_of(flag));
  return {{"printed", json(row.plan.printed)},
          {"reference",
           result.request.reference ? Json(reference_label(result.request)) : Json()},
          {"cells", result.request.settings.body.block.cells},
          {"status", name_of(result.status)},
          {"flags", flags},
          {"reason", json(result.reason)},
          {"load_fraction", result.solution.load_fraction}};
}

TableRow row_of(const ComparisonRow& row) {
  const CaseResult& result = row.result;
  TableRow own{.cells = {row.plan.labels.begin(), row.plan.labels.end()},
               .notes = row.plan.notes,
               .cases = {result.key},
               .in_json = json_of(row)};
  own.cells.insert(
      own.cells.end(),
      {row.plan.printed_text,
       {row.ours, instead_of_value(result)},
       row.difference,
       row.reference_value,
       row.reference_bar,
       row.reference_order,
       reference_of(result),
       fmt::format("{}", fmt::join(result.request.settings.body.block.cells, "x")),
       row.plan.verdict,
       status_words(result)});
  own.cells.insert(own.cells.end(), row.further.begin(), row.further.end());
  return own;
}

/// What JSON tells of the table as a whole.
Json json_of(const ComparisonPlan& plan) {
  Json further = Json::array();
  for (const Quantity& quantity : plan.further)
    further.push_back({{"key", heading(quantity)}, {"format", quantity.format}});
  return {{"labels", plan.label_headings},
          {"quantity", plan.quantity.name},
          {"unit", plan.quantity.unit},
          {"format", plan.quantity.format},
          {"further", further}};
}

}  // namespace

Table table_of(const Comparison& comparison) {
  Table table{
      .columns = columns_of(comparison.plan),
      .notes =
          {"Reference: the solution (method:element, on the same mesh unless @ says "
           "otherwise) that deviations and the columns \"reference's\" belong to; with "
           "@converged, its error bound (+-) and the order observed."},
      .in_json = json_of(comparison.plan),
      .finding = against_thesis(comparison)};
  table.notes.insert(table.notes.end(), comparison.plan.notes.begin(),
                     comparison.plan.notes.end());
  for (const ComparisonRow& row : comparison.rows) {
    table.rows.push_back(row_of(row));
    if (row.result.status != Status::ok)
      table.bad_cases.push_back({.name = row_name(comparison, row),
                                 .status = std::string(name_of(row.result.status)),
                                 .reason = row.result.reason});
  }
  return table;
}

}  // namespace springcheck
