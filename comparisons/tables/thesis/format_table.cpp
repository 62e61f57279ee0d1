#include "comparisons/tables/thesis/format_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/sheets/sheet.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

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

std::string reference_of(const CaseResult& result) {
  return result.request.reference ? reference_label(result.request) : "itself";
}

/// What tables to be read show.
Sheet sheet_of(const Table& table) {
  const auto& [name, title, labels, quantity, further, rows, notes] = table.plan;
  const std::string shown = heading(quantity), &format = quantity.format;
  const std::string unit =
      quantity.unit == "-"
          ? ""
          : fmt::format(" [{}]", quantity.unit == "%" ? "points" : quantity.unit);
  Sheet sheet{
      .name = name,
      .title = title,
      .notes = {
          "Reference: the solution (method:element, on the same mesh unless @ says "
          "otherwise) that deviations and the columns \"reference's\" belong to; with "
          "@converged, its error bound (+-) and the order observed."}};
  sheet.notes.insert(sheet.notes.end(), notes.begin(), notes.end());
  for (const std::string& label : labels) sheet.columns.push_back({label, label});
  sheet.columns.insert(sheet.columns.end(),
                       {{"printed", "printed " + shown},
                        {"ours", "ours " + shown, format},
                        {"difference", "ours - printed" + unit, format, true},
                        {"reference_value", "reference's " + shown, format},
                        {"reference_bar", "reference's +-", "{:.1g}"},
                        {"reference_order", "reference's order", "{:.2f}"},
                        {"reference", "reference"},
                        {"cells", "mesh"},
                        {"printed_instabilities", "printed instabilities"},
                        {"status", "status"}});
  for (const Quantity& one : further)
    sheet.columns.push_back({heading(one), heading(one), one.format});
  for (const TableRow& row : table.rows) {
    const CaseResult& result = row.result;
    SheetRow own{.cells = {row.plan.labels.begin(), row.plan.labels.end()},
                 .notes = row.plan.notes,
                 .cases = {result.key}};
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
    sheet.rows.push_back(std::move(own));
  }
  return sheet;
}

/// Without what only the screen has room for: further measures beside printed values.
Table narrowed(Table table) {
  if (std::ranges::any_of(
          table.rows, [](const TableRow& row) { return row.plan.printed.has_value(); })) {
    table.plan.further.clear();
    for (TableRow& row : table.rows) row.further.clear();
  }
  return table;
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
  if (format == TableFormat::json) return json_text(table);
  const bool is_narrow = format == TableFormat::latex;
  return format_sheet(sheet_of(is_narrow ? narrowed(table) : table), format);
}

}  // namespace springcheck
