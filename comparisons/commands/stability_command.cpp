#include "comparisons/commands/stability_command.hpp"

#include <fmt/format.h>

#include "comparisons/settings/scene_file.hpp"
#include "comparisons/stability/atlas_tables.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {

ExitStatus stability_command(const std::string& scene,
                             const std::vector<GivenSetting>& options,
                             const StabilityOptions& stability) {
  AtlasPlan plan{.scene = scene, .options = options, .judges_locking = stability.locking};
  const Test test = read_run(scene, options).common.test;
  for (const std::string& text : stability.over)
    for (Axis& axis : axes_named("--over", text, test))
      plan.axes.push_back(std::move(axis));
  if (plan.axes.empty() || plan.axes.size() > 2)
    throw InputError("--over", "", "one or two axes", std::to_string(plan.axes.size()));
  if (plan.axes.size() == 2 && plan.axes[0].key == plan.axes[1].key)
    throw InputError("--over", "", "two different settings",
                     "'" + plan.axes[0].key + "' twice");
  CaseRunner runner(stability.out, stability.jobs, stability.revisions);
  const Atlas atlas = make_atlas(plan, runner);
  const OtherRevisions others = runner.others();
  if (stability.format) {
    std::vector<Table> tables{points_table(atlas, plan), limits_table(atlas, plan)};
    if (!others.empty())
      for (Table& table : tables) table.notes.push_back(note_of_taken(others));
    fmt::print("{}", format_tables(tables, *stability.format));
  } else {
    fmt::print("{}", maps_text(atlas, plan));
    if (!atlas.limits.empty())
      fmt::print("\n{}", table_in_columns(limits_table(atlas, plan), {"reason"}));
    fmt::print("\n{} simulations computed, {} points.\n", runner.computed(),
               atlas.points.size());
    if (!others.empty()) fmt::print("{}\n", note_of_taken(others));
  }
  return ExitStatus::done;
}

}  // namespace springcheck
