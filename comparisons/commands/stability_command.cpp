#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "comparisons/command_line/options.hpp"
#include "comparisons/command_line/screen.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/options/computing.hpp"
#include "comparisons/commands/options/input_options.hpp"
#include "comparisons/commands/options/interrupted.hpp"
#include "comparisons/commands/options/setting_options.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/stability/atlas_tables.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

struct StabilityOptions {
  std::string scene{};
  SettingOptions settings{};
  std::vector<std::string> over{};  // see axes_named
  std::optional<std::filesystem::path> out{};
  std::optional<TableFormat> format{};  // none: maps and limits for a terminal
  bool locking = false;                 // see AtlasPlan
  int jobs = all_cores();
  Revisions revisions = Revisions::own;
};

ExitStatus map_failures(const StabilityOptions& stability) {
  const Computing computing(stability.jobs);
  AtlasPlan plan{.scene = stability.scene,
                 .options = stability.settings.given(),
                 .judges_locking = stability.locking};
  const Test test = read_run(plan.scene, plan.options).common.test;
  for (const std::string& text : stability.over)
    for (Axis& axis : axes_named("--over", text, test))
      plan.axes.push_back(std::move(axis));
  if (plan.axes.empty() || plan.axes.size() > 2)
    throw InputError("--over", "", "one or two axes", std::to_string(plan.axes.size()));
  if (plan.axes.size() == 2 && plan.axes[0].key == plan.axes[1].key)
    throw InputError("--over", "", "two different settings",
                     "'" + plan.axes[0].key + "' twice");
  const BeforeInterruption kept = tell_that_it_goes_on(stability.out);
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
      fmt::print("\n{}", table_in_columns(limits_table(atlas, plan), screen_of_output(),
                                          {"reason"}));
    fmt::print("\n{} simulations computed, {} points.\n", runner.computed(),
               atlas.points.size());
    if (!others.empty()) fmt::print("{}\n", note_of_taken(others));
  }
  return ExitStatus::done;
}

Action declare_stability(CLI::App& parser) {
  const auto options = std::make_shared<StabilityOptions>();
  add_scene(parser, options->scene);
  options->settings.add_to(parser, is_any);
  parser
      .add_option("--over", options->over,
                  "KEY=FROM:TO:COUNT, KEY=FROM:TO:log:COUNT or KEY=A,B,C, once or twice, "
                  "or KEY[,KEY] over usual values; limits are along the first")
      ->required()
      ->type_name("KEY=VALUES");
  parser.add_flag("--locking", options->locking,
                  "judge locking, too, by a control for every point");
  add_path(parser, "--out", options->out, "FILE", "HDF5 file to add the cases to")
      ->group(of_output);
  add_format(parser, options->format, "maps and limits");
  add_revisions(parser, options->revisions, "cases in the file");
  add_jobs(parser, options->jobs, "simulations");
  return [options] { return map_failures(*options); };
}

}  // namespace

Command stability_command() {
  return {.name = "stability",
          .summary = "Map where methods fail over one or two settings, and their limits",
          .description = "What the file of --out holds is not computed again.",
          .examples = {{"springcheck stability compression --over deformation",
                        "up to where each of the scene's methods holds"},
                       {"springcheck stability compression --over deformation=5%:60%:12 "
                        "--over nu --method mss-cf,mss-affine --out map.h5",
                        "a map over two settings, kept for the page"}},
          .declare = declare_stability};
}

}  // namespace springcheck
