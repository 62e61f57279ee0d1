#include "comparisons/stability/stability_command.hpp"

#include <fmt/format.h>

#include "comparisons/scene_file.hpp"
#include "comparisons/stability/atlas_sheets.hpp"
#include "comparisons/text_table.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

std::string limits_text(const Atlas& atlas, const AtlasPlan& plan) {
  const Sheet sheet = limits_sheet(atlas, plan);
  TextLines lines{{}};
  for (const Column& column : sheet.columns)
    if (column.key != "reason") lines[0].push_back(column.heading);
  for (const SheetRow& row : sheet.rows) {
    lines.emplace_back();
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      if (sheet.columns[i].key != "reason")
        lines.back().push_back(
            row.cells[i].number ? rounded(sheet.columns[i].format, *row.cells[i].number)
                                : row.cells[i].text);
  }
  return in_columns(lines);
}

}  // namespace

ExitStatus stability_command(const std::string& scene,
                             const std::vector<GivenSetting>& options,
                             const StabilityOptions& stability) {
  AtlasPlan plan{.scene = scene,
                 .options = options,
                 .axes = {},
                 .judges_locking = stability.locking};
  const Test test = read_run(scene, options).common.test;
  for (const std::string& text : stability.over)
    for (Axis& axis : axes_named("--over", text, test))
      plan.axes.push_back(std::move(axis));
  if (plan.axes.empty() || plan.axes.size() > 2)
    throw InputError("--over", "", "one or two axes", std::to_string(plan.axes.size()));
  if (plan.axes.size() == 2 && plan.axes[0].key == plan.axes[1].key)
    throw InputError("--over", "", "two different settings",
                     "'" + plan.axes[0].key + "' twice");
  CaseRunner runner(stability.out, stability.jobs);
  const Atlas atlas = make_atlas(plan, runner);
  if (stability.format) {
    const bool is_json = *stability.format == TableFormat::json;  // one document
    fmt::print("{}{}{}{}{}", is_json ? "[\n" : "",
               format_sheet(points_sheet(atlas, plan), *stability.format),
               is_json ? ",\n" : "\n",
               format_sheet(limits_sheet(atlas, plan), *stability.format),
               is_json ? "]\n" : "");
  } else {
    fmt::print("{}", maps_text(atlas, plan));
    if (!atlas.limits.empty()) fmt::print("\n{}", limits_text(atlas, plan));
    fmt::print("\n{} simulations computed, {} points.\n", runner.computed(),
               atlas.points.size());
  }
  return ExitStatus::done;
}

}  // namespace springcheck
