#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <set>

#include "comparisons/chart/chart_run.hpp"
#include "comparisons/chart/chart_tables.hpp"
#include "comparisons/chart/claims.hpp"
#include "comparisons/command_line/options.hpp"
#include "comparisons/command_line/screen.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/options/chart_options.hpp"
#include "comparisons/commands/options/computing.hpp"
#include "comparisons/commands/options/interrupted.hpp"
#include "comparisons/commands/options/setting_options.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

struct ChartOptions {
  std::string scene{};
  SettingOptions settings{};
  std::string sizes = "4,6,10,16";  // cells across
  std::string threads{};            // "1,2"; empty: 1 and all
  double budget = 8;                // [s] that a point's solution may take
  double repeat_for = 1;            // [s] of a point's repetitions, in all rounds
  std::string law{};  // of the scene's own truth; empty: that of its reference
  std::filesystem::path out{};
  std::optional<TableFormat> format{};  // none: truths, fronts and claims for a terminal
  int jobs = all_cores();               // truths at once, at most
  bool retime = false;
  bool quick = false;                 // quick_plan's models, sizes and times
  int least_models = 12;              // see ChartRun::measure_beyond_budget
  std::optional<int> truth_across{};  // see truth_grids
};

/// Different counts of at least 1, ascending, as "4,6,10,16".
std::vector<int> counts_in(const std::string& option, const std::string& text, int most) {
  const std::string expected =
      fmt::format("different whole numbers from 1 to {}, with commas between", most);
  std::set<int> counts;
  std::size_t given = 0;
  for (std::size_t first = 0; first <= text.size(); ++given) {
    const std::size_t comma = std::min(text.find(',', first), text.size());
    const std::string one = text.substr(first, comma - first);
    if (one.empty() || one.size() > 4 || one.find_first_not_of("0123456789") < one.size())
      throw InputError(option, "", expected, "'" + text + "'");
    counts.insert(std::stoi(one));
    first = comma + 1;
  }
  if (counts.size() < given || *counts.begin() < 1 || *counts.rbegin() > most)
    throw InputError(option, "", expected, "'" + text + "'");
  return {counts.begin(), counts.end()};
}

std::vector<int> thread_counts(const std::string& text) {
  const int most = all_cores();
  if (!text.empty()) return counts_in("--on-threads", text, most);
  if (most == 1) return {1};
  return {1, most};
}

/// The front of the scene's own law.
Table own_front(const Chart& chart) {
  Table table = front_table({chart});
  const auto law = std::ranges::find(table.columns, "law", &Column::key);
  const auto place = static_cast<std::size_t>(law - table.columns.begin());
  std::erase_if(table.rows, [&](const TableRow& row) {
    return row.cells[place].text != chart.stored.law;
  });
  return table;
}

std::string chart_text(const Chart& chart, const std::string& caution) {
  const Screen screen = screen_of_output();
  std::string text =
      fmt::format("{}\n\n{}\nFronts, law {}\n\n{}\n", chart.stored.scene,
                  table_in_columns(truths_table({chart}), screen), chart.stored.law,
                  table_in_columns(own_front(chart), screen));
  if (!caution.empty()) text += in_lines("Caution: " + caution, screen) + "\n\n";
  for (const Claim& claim : claims(chart))
    text += in_lines(fmt::format("{}, {}: {}", name_of(claim.kind),
                                 name_of(claim.measure), claim_text(chart, claim)),
                     screen) +
            "\n";
  const auto left_out = std::ranges::count_if(
      chart.points, [](const ChartPoint& point) { return !point.seconds(); });
  const auto failed = std::ranges::count_if(chart.points, [](const ChartPoint& point) {
    return point.seconds() && !point.is_ok();
  });
  return text + fmt::format(
                    "\n{} points, {} of them failed, {} left out: over budget or "
                    "memory, or not applicable.\n",
                    chart.points.size(), failed, left_out);
}

/// The plan of a scene, or the plans of the five scenes of the thesis ("all").
std::vector<ChartPlan> plans_of(const ChartOptions& chart) {
  const GivenSettings options = chart.settings.given();
  const std::vector<int> across = counts_in("--sizes", chart.sizes, 1000);
  const std::vector<int> threads = thread_counts(chart.threads);
  std::vector<std::string> scenes{chart.scene};
  if (chart.scene == "all")
    scenes = {"compression", "tension", "shearing", "torsion", "bending"};
  std::vector<ChartPlan> plans;
  for (const std::string& one : scenes) {
    if (chart.quick) {
      plans.push_back(quick_plan(one, threads.back(), chart.jobs));
      plans.back().options = options;
      continue;
    }
    plans.push_back({.scene = one,
                     .options = options,
                     .law = truth_law_named(chart.law),
                     .laws = truth_laws(),
                     .across = across,
                     .threads = threads,
                     .budget = chart.budget,
                     .repeat_for = std::min(chart.repeat_for, chart.budget),
                     .jobs = chart.jobs,
                     .retime = chart.retime,
                     .least_models = chart.least_models,
                     .truth_across = chart.truth_across});
  }
  for (const ChartPlan& plan : plans) check_plan(plan);
  return plans;
}

/// Measures how long each model takes and how far it is off the truth. What the result
/// file holds is not measured again.
ExitStatus measure_models(const ChartOptions& chart) {
  const Computing computing(std::max(chart.jobs, all_cores()), chart.jobs);
  const std::vector<ChartPlan> plans = plans_of(chart);
  const BeforeInterruption kept =
      chart.retime ? tell_what_is_kept(chart.out) : tell_that_it_goes_on(chart.out);
  std::vector<Chart> charts;
  for (const ChartPlan& plan : plans) {
    charts.push_back(make_chart(plan, chart.out));
    if (!chart.format)
      fmt::print("{}\n", chart_text(charts.back(), caution_of_truth(plan)));
  }
  if (chart.format) fmt::print("{}", format_tables(chart_tables(charts), *chart.format));
  return ExitStatus::done;
}

void declare_measurements(CLI::App& parser, ChartOptions& options) {
  const auto add = [&](CLI::Option* option) { option->group("measurements"); };
  add(parser.add_option("--sizes", options.sizes, "cells across the shortest edge")
          ->type_name("COUNTS")
          ->capture_default_str());
  add(parser
          .add_option("--on-threads", options.threads,
                      "numbers of threads that are timed (default: 1 and all cores)")
          ->type_name("COUNTS"));
  add(add_seconds(parser, "--budget", options.budget, false,
                  "seconds that a point's solution may take"));
  add(add_seconds(parser, "--repeat-for", options.repeat_for, false,
                  "seconds for the repetitions of each point"));
  add(add_converged_across(parser, options.truth_across));
  add(add_converged_law(parser, options.law));
  add(parser.add_flag("--retime", options.retime,
                      "time again what the file has a time of, and nothing else"));
  add(add_count(
          parser, "--least-models", options.least_models, 0, 1000,
          "models at equilibrium that get to the finest cells and are ok there, the "
          "cheapest first, whatever the budget")
          ->capture_default_str());
  CLI::Option* const quick = parser.add_flag(
      "--quick", options.quick,
      "the models that people want to see first, on 4, 6 and 10 cells across, beside the "
      "converged solution of the scene's own law alone, in about a minute a scene");
  for (const char* option :
       {"--sizes", "--on-threads", "--budget", "--repeat-for", "--converged-across",
        "--converged-law", "--retime", "--least-models"})
    quick->excludes(parser.get_option(option));
  add(quick);
}

Action declare_chart(CLI::App& parser) {
  const auto options = std::make_shared<ChartOptions>();
  parser
      .add_option("scene", options->scene,
                  "name of a shipped scene, a .toml file, or all: the thesis's five")
      ->required()
      ->type_name("SCENE|FILE|all");
  options->settings.add_to(parser, is_taken_by_charts);
  declare_measurements(parser, *options);
  add_path(parser, "--out", options->out, "FILE", "HDF5 file to add the chart to")
      ->required()
      ->group(of_output);
  add_format(parser, options->format, "converged solutions, fronts and claims");
  add_jobs(parser, options->jobs, "converged solutions' grids");
  return [options] { return measure_models(*options); };
}

}  // namespace

Command chart_command() {
  return {.name = "chart",
          .summary = "Measure time against accuracy of every model on a scene",
          .description = "What the file of --out holds is not measured again.",
          .examples = {{"springcheck chart compression --out chart.h5 --quick",
                        "the models that people want to see first, in about a minute"},
                       {"springcheck chart all --out charts.h5",
                        "every model on the thesis's five scenes, in hours"}},
          .declare = declare_chart};
}

}  // namespace springcheck
