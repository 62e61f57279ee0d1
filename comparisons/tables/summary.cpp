#include "comparisons/tables/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/tables/catalogue.hpp"

namespace springcheck {
namespace {

/// "nu 0, deformation 5 %, method mss-cf".
std::string row_name(const Table& table, const TableRow& row) {
  std::string name;
  for (std::size_t i = 0; i < row.plan.labels.size(); ++i)
    name += fmt::format("{}{} {}", i == 0 ? "" : ", ", table.plan.label_headings[i],
                        row.plan.labels[i]);
  return name;
}

/// The row of a method that is furthest from its printed value, relative to it or, for
/// printed percentages, in points. Empty when none has a printed value.
std::string worst_against_thesis(const Table& table, const std::string& method) {
  const bool points = table.plan.quantity.unit == "%";
  const TableRow* worst = nullptr;
  double largest = -1;
  int compared = 0;
  for (const TableRow& row : table.rows) {
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
      row_name(table, *worst),
      points ? fmt::format("{:+.2f} points", *worst->difference)
             : fmt::format("{:+.1f} %", 100 * *worst->difference / *worst->plan.printed),
      worst->plan.notes.empty() ? "" : ": see its notes in the table");
}

/// mss-cf against the thesis's own, and the law nearest to its FEM column.
std::string against_thesis(const Table& table) {
  std::string text = worst_against_thesis(table, "mss-cf");
  if (text.empty()) return "no printed figure of mss-cf to compare with";
  const std::string fem = worst_against_thesis(table, "fem-hencky");
  return fem.empty() ? text : text + "; " + fem;
}

}  // namespace

std::string summary(const TableSet& set, const std::map<std::string, Status>& statuses,
                    double seconds) {
  const auto& [tables, sheets] = set;
  std::map<Status, int> count;
  for (const auto& [key, status] : statuses) ++count[status];
  std::string text = fmt::format(
      "# springcheck {}: the thesis's comparison tables, regenerated\n\n"
      "Commit {}. {} cases; this run took {:.0f} s before the page.\n\n"
      "Printed figures: K. Golec, \"Hybrid 3D Mass Spring System for Soft Tissue "
      "Simulation\", PhD thesis, 2018, section 5.6. Ours: static equilibria of the same "
      "scenes. Every row of a table names its case in results.h5. "
      "index.html shows these and further sweeps.\n\n"
      "| status | cases |\n| --- | --- |\n",
      build_info::version, build_info::commit, statuses.size(), seconds);
  for (const auto& [status, cases] : count)
    text += fmt::format("| {} | {} |\n", name_of(status), cases);
  text += "\n## Against the printed figures\n\n";
  for (const Table& table : tables)
    text += fmt::format("- [{}](tables/{}.md): {}\n", table.plan.title, table.plan.name,
                        against_thesis(table));
  text += "\n## Tables of our own figures\n\n";
  for (const Sheet& sheet : sheets)
    text += fmt::format("- [{}](tables/{}.md)\n", sheet.title, sheet.name);
  for (const std::string& name : sheet_names())
    if (std::ranges::count(sheets, name, &Sheet::name) == 0)
      text += fmt::format("- {0} is left out{1}: `springcheck table {0}`, or {2}\n", name,
                          std::ranges::count(long_sheet_names(), name) > 0
                              ? " and takes many minutes"
                              : "",
                          "`springcheck reproduce --all`");
  text +=
      "\n## Cases that are not ok\n\n| table | case | status | why |\n"
      "| --- | --- | --- | --- |\n";
  for (const Table& table : tables)
    for (const TableRow& row : table.rows)
      if (row.result.status != Status::ok)
        text +=
            fmt::format("| {} | {} | {} | {} |\n", table.plan.name, row_name(table, row),
                        name_of(row.result.status), row.result.reason);
  return text;
}

}  // namespace springcheck
