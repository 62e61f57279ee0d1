#include "comparisons/commands/chart_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <thread>

#include "comparisons/chart/chart_run.hpp"
#include "comparisons/chart/chart_tables.hpp"
#include "comparisons/chart/claims.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

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
  const int most = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
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
  std::string text = fmt::format("{}\n\n{}\nFronts, law {}\n\n{}\n", chart.stored.scene,
                                 table_in_columns(truths_table({chart})),
                                 chart.stored.law, table_in_columns(own_front(chart)));
  if (!caution.empty()) text += fmt::format("Caution: {}\n\n", caution);
  for (const Claim& claim : claims(chart))
    text += fmt::format("{}, {}: {}\n", name_of(claim.kind), name_of(claim.measure),
                        claim_text(chart, claim));
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

}  // namespace

ExitStatus chart_command(const std::string& scene,
                         const std::vector<GivenSetting>& options,
                         const ChartOptions& chart) {
  const std::vector<int> across = counts_in("--sizes", chart.sizes, 1000);
  const std::vector<int> threads = thread_counts(chart.threads);
  std::vector<std::string> scenes{scene};
  if (scene == "all")
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
  std::vector<Chart> charts;
  for (const ChartPlan& plan : plans) {
    charts.push_back(make_chart(plan, chart.out));
    if (!chart.format)
      fmt::print("{}\n", chart_text(charts.back(), caution_of_truth(plan)));
  }
  if (chart.format) fmt::print("{}", format_tables(chart_tables(charts), *chart.format));
  return ExitStatus::done;
}

}  // namespace springcheck
