#include "comparisons/chart/chart_tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/chart/chart_models.hpp"
#include "comparisons/chart/claims.hpp"

namespace springcheck {
namespace {

std::optional<double> in_percent(const std::optional<double>& fraction) {
  return fraction ? std::optional(100 * *fraction) : std::nullopt;
}

/// An error, or the status that stands in its place.
Cell error_cell(const ChartPoint& point, std::size_t truth, ChartMeasure measure) {
  return {in_percent(point.errors[truth].of(measure)),
          !point.found || point.is_ok() ? "" : std::string(name_of(point.found->status))};
}

/// Notes the other revisions that charts, and so their cases, are of.
void add_revisions(Table& table, const std::vector<Chart>& charts) {
  std::set<std::string> others;
  for (const Chart& chart : charts)
    if (chart.stored.revision != build_info::revision)
      others.insert(chart.stored.revision);
  for (const std::string& other : others)
    table.notes.push_back(fmt::format(
        "Of revision {} of the numerics, as asked: what was measured by it.", other));
}

std::string machines_of(const std::vector<Chart>& charts) {
  std::string text;
  std::set<std::string> seen;
  for (const Chart& chart : charts)
    if (seen.insert(chart.stored.machine).second)
      text += (text.empty() ? "Measured on " : "; on ") + chart.stored.machine;
  return text + ".";
}

const char* const what_errors_are =
    "Errors, against what the law converges to: force, the plate's force or torque or "
    "the tip's drop, over the converged one; volume, |V - V*|/(V0 e) with the imposed "
    "strain e; "
    "deviation, volume-weighted root mean square distance of the free nodes over the "
    "largest displacement imposed (bending: the converged drop of the tip).";

/// Notes that a point is judged by what follows from its own figures, if it is.
void note_own_truth(TableRow& row, const Chart& chart, std::size_t point,
                    std::size_t truth) {
  if (chart.tells_truth(point, truth))
    row.notes.emplace_back("One of the grids that the converged solution is told from.");
}

/// Notes which limits contradict each other in a truth's number, if they do.
void note_unresolved(TableRow& row, const CheckedNumber& number,
                     const std::string& name) {
  if (!number.is_resolved)
    row.notes.push_back(
        fmt::format("Unresolved: the limits of {} and {} contradict each other in the "
                    "{}, by more than both bounds.",
                    truth_element, check_element, name));
}

void add_point(Table& table, const Chart& chart, std::size_t place_in_chart,
               const std::optional<std::size_t>& truth) {
  const ChartPoint& point = chart.points[place_in_chart];
  const StoredChart::Point& place = point.place;
  TableRow row{
      .cells = {chart.stored.scene, name_of(place.kind), name_of(place.model),
                place.across, place.cells, place.nodes, place.threads, status_of(point)},
      .cases = {place.key},
      .part = identity_of(chart.stored)};
  for (const ChartMeasure measure : all_values<ChartMeasure>())
    row.cells.push_back(truth ? error_cell(point, *truth, measure) : Cell{});
  const auto& timing = place.timing;
  row.cells.insert(
      row.cells.end(),
      {point.seconds(), point.seconds_at(&Timing::minimum),
       point.seconds_at(&Timing::lower_quartile),
       point.seconds_at(&Timing::upper_quartile),
       timing ? Cell(timing->repetitions) : Cell(),
       timing ? Cell(timing->rounds) : Cell(), point.seconds_at(&Timing::fastest_round),
       point.seconds_at(&Timing::slowest_round), place.setup});
  if (point.found) {
    const Effort effort = point.found->effort.value_or(Effort{});
    row.cells.insert(row.cells.end(),
                     {effort.steps, effort.force_evaluations,
                      std::optional<double>(point.found->factorisations),
                      std::optional<double>(point.found->linear_iterations)});
  } else {
    row.cells.resize(row.cells.size() + 4);
  }
  if (truth && !point.compared[*truth].empty())
    row.cases.push_back(point.compared[*truth]);
  if (truth) note_own_truth(row, chart, place_in_chart, *truth);
  table.rows.push_back(std::move(row));
}

}  // namespace

Table truths_table(const std::vector<Chart>& charts) {
  Table table{
      .name = "chart-converged",
      .title = "Converged solutions of the charts: of q2 and q1-sri on three grids each",
      .columns = {{"scene", "scene"},
                  {"law", "law"},
                  {"measure", "answer"},
                  {"answer", "value [N, N m or m]", "{:.7g}"},
                  {"answer_bar", "+- [%]", "{:.2g}"},
                  {"answer_order", "order", "{:.2f}"},
                  {"answer_element", "by"},
                  {"answer_apart", "limits apart [%]", "{:.2g}"},
                  {"volume_change", "volume change [%]", "{:.6f}"},
                  {"volume_bar", "+- over the strain [%]", "{:.2g}"},
                  {"volume_order", "order", "{:.2f}"},
                  {"volume_element", "by"},
                  {"volume_apart", "limits apart over the strain [%]", "{:.2g}"},
                  {"deviation_bar", "places +- [%]", "{:.2g}"},
                  {"deviation_apart", "places apart [%]", "{:.2g}"}},
      .notes = {
          "Richardson's extrapolation of the three grids, and the half width of its "
          "error bound, which holds the grid convergence index with the safety of "
          "Oberkampf and Roy about the finest grid, over what errors are told by: the "
          "answer, the imposed strain, the largest imposed displacement; the last is the "
          "largest of all meshes. An error below it says no more than that.",
          "Two discretisations tell each number, q2 and, on the same nodes, q1-sri; it "
          "is that of the narrower bound, which is at least what the other's limit is "
          "off it. Where the two are farther apart than both bounds, a note says so, and "
          "the bound holds all that the other's allows. Places are those of q2."}};
  for (const Chart& chart : charts)
    for (const ChartTruth& truth : chart.truths) {
      const StoredChart::Truth& of = truth.grids;
      const auto apart = [](const CheckedNumber& number, double unit) {
        return Cell{number.disagreement ? std::optional(100 * *number.disagreement / unit)
                                        : std::nullopt,
                    "not checked"};
      };
      TableRow row{
          .cells = {chart.stored.scene,
                    of.law,
                    chart.stored.answer,
                    truth.answer.value,
                    in_percent(truth.error_bounds.force),
                    {truth.answer.order, "none"},
                    element_of(truth.answer),
                    apart(truth.answer, std::abs(truth.answer.value)),
                    100 * truth.volume_change.value,
                    in_percent(truth.error_bounds.volume),
                    {truth.volume_change.order, "none"},
                    element_of(truth.volume_change),
                    apart(truth.volume_change, truth.imposed / chart.stored.height),
                    in_percent(truth.error_bounds.deviation),
                    in_percent(of.places_apart)},
          .cases = {of.grids.keys.rbegin(), of.grids.keys.rend()},
          .part = identity_of(chart.stored)};
      if (of.check)
        row.cases.insert(row.cases.end(), of.check->keys.rbegin(), of.check->keys.rend());
      note_unresolved(row, truth.answer, "answer");
      note_unresolved(row, truth.volume_change, "change of volume");
      table.rows.push_back(std::move(row));
    }
  return table;
}

Table points_table(const std::vector<Chart>& charts) {
  Table table{
      .name = "chart",
      .title = "Work and precision: errors against what each scene's law converges to",
      .columns = {{"scene", "scene"},
                  {"kind", "kind"},
                  {"model", "model"},
                  {"across", "across", "{:.0f}"},
                  {"cells", "cells", "{:.0f}"},
                  {"nodes", "nodes", "{:.0f}"},
                  {"threads", "threads", "{:.0f}"},
                  {"status", "status"},
                  {"force", "force off [%]", "{:.3g}"},
                  {"volume", "volume off [%]", "{:.3g}"},
                  {"deviation", "deviation [%]", "{:.3g}"},
                  {"median", "time [s]", "{:.3g}"},
                  {"minimum", "least [s]", "{:.3g}"},
                  {"lower_quartile", "lower quartile [s]", "{:.3g}"},
                  {"upper_quartile", "upper quartile [s]", "{:.3g}"},
                  {"repetitions", "runs", "{:.0f}"},
                  {"rounds", "rounds", "{:.0f}"},
                  {"fastest_round", "fastest round [s]", "{:.3g}"},
                  {"slowest_round", "slowest round [s]", "{:.3g}"},
                  {"setup", "of it set-up [s]", "{:.2g}"},
                  {"steps", "steps", "{:.0f}"},
                  {"force_evaluations", "force evaluations", "{:.0f}"},
                  {"factorisations", "factorisations", "{:.0f}"},
                  {"linear_iterations", "linear iterations", "{:.0f}"}},
      .notes = {what_errors_are,
                "Time: median; of an equilibrium to a relative residual of 1e-10, of a "
                "motion real seconds per simulated one at .9 of the method's own "
                "stability limit, set-up and all. Set-up is of the whole run. "
                "Median and quartiles: of all runs, each round counting the same; what "
                "took longer than a round's share has one run in each, or one in all, "
                "without a warm-up. "
                "A point without a time would have taken more than the budget, or the "
                "memory that was left.",
                machines_of(charts)}};
  for (const Chart& chart : charts) {
    const auto truth = chart.truth_of(chart.stored.law);
    for (std::size_t i = 0; i < chart.points.size(); ++i)
      add_point(table, chart, i, truth);
  }
  return table;
}

Table laws_table(const std::vector<Chart>& charts) {
  Table table{.name = "chart-laws",
              .title = "Errors of the charts' cases against what every law converges to",
              .columns = {{"scene", "scene"},
                          {"kind", "kind"},
                          {"model", "model"},
                          {"across", "across", "{:.0f}"},
                          {"law", "law"},
                          {"status", "status"},
                          {"force", "force off [%]", "{:.3g}"},
                          {"volume", "volume off [%]", "{:.3g}"},
                          {"deviation", "deviation [%]", "{:.3g}"}},
              .notes = {what_errors_are}};
  for (const Chart& chart : charts) {
    std::set<std::pair<std::string, std::string>> seen;
    for (std::size_t place = 0; place < chart.points.size(); ++place) {
      const ChartPoint& point = chart.points[place];
      if (!point.found) continue;
      if (!seen.insert({name_of(point.place.model), point.place.key}).second)
        continue;  // threads
      for (std::size_t i = 0; i < chart.truths.size(); ++i) {
        TableRow row{.cells = {chart.stored.scene, name_of(point.place.kind),
                               name_of(point.place.model), point.place.across,
                               chart.truths[i].grids.law, status_of(point)},
                     .cases = {point.place.key},
                     .part = identity_of(chart.stored)};
        for (const ChartMeasure measure : all_values<ChartMeasure>())
          row.cells.push_back(error_cell(point, i, measure));
        if (!point.compared[i].empty()) row.cases.push_back(point.compared[i]);
        note_own_truth(row, chart, place, i);
        table.rows.push_back(std::move(row));
      }
    }
  }
  return table;
}

Table front_table(const std::vector<Chart>& charts) {
  Table table{
      .name = "chart-front",
      .title = "Fronts of the charts: no model is both faster and more accurate",
      .columns = {{"scene", "scene"},
                  {"kind", "kind"},
                  {"law", "law"},
                  {"measure", "measure"},
                  {"error", "off [%]", "{:.3g}"},
                  {"median", "time [s]", "{:.3g}"},
                  {"lower_quartile", "lower quartile [s]", "{:.3g}"},
                  {"upper_quartile", "upper quartile [s]", "{:.3g}"},
                  {"model", "model"},
                  {"across", "across", "{:.0f}"},
                  {"threads", "threads", "{:.0f}"},
                  {"rivals", "rivals", "{:.0f}"}},
      .notes = {
          what_errors_are,
          "A front goes from the fastest point to the most accurate, each the fastest "
          "that is more accurate than the one before by 1 % of the error or more, over "
          "all numbers of threads. Failed states, wrinkled and indefinite ones among "
          "them, have no place on it.",
          "Rivals: other points, as accurate but for less than 1 %, that cannot be told "
          "to be slower. Times are told apart where medians differ by a fifth and three "
          "rounds of one are all faster than the other's; where one has fewer, the "
          "quartiles must not overlap. Timed again, a rival may have the place; a point "
          "without any is expected to keep it."}};
  for (const Chart& chart : charts)
    for (const ChartKind kind : {ChartKind::equilibrium, ChartKind::motion})
      for (std::size_t truth = 0; truth < chart.truths.size(); ++truth)
        for (const ChartMeasure measure : all_values<ChartMeasure>())
          for (const std::size_t i : chart.front(kind, measure, truth)) {
            const ChartPoint& point = chart.points[i];
            TableRow row{
                .cells = {chart.stored.scene, name_of(kind),
                          chart.truths[truth].grids.law, name_of(measure),
                          in_percent(point.errors[truth].of(measure)), point.seconds(),
                          point.seconds_at(&Timing::lower_quartile),
                          point.seconds_at(&Timing::upper_quartile),
                          name_of(point.place.model), point.place.across,
                          point.place.threads, chart.rivals(i, measure, truth).size()},
                .cases = {point.place.key},
                .part = identity_of(chart.stored)};
            const auto error_bound = chart.error_bound(i, measure, truth);
            if (error_bound && *point.errors[truth].of(measure) < *error_bound)
              row.notes.emplace_back("Below the bound of the converged solution itself.");
            note_own_truth(row, chart, i, truth);
            table.rows.push_back(std::move(row));
          }
  return table;
}

const std::vector<std::string>& chart_table_names() {
  static const std::vector<std::string> all{"chart-converged", "chart", "chart-laws",
                                            "chart-front", "chart-claims"};
  return all;
}

std::vector<Table> chart_tables(const std::vector<Chart>& charts) {
  if (charts.empty()) return {};
  std::vector<Table> tables{truths_table(charts), points_table(charts),
                            laws_table(charts), front_table(charts),
                            claims_table(charts)};
  for (Table& table : tables) add_revisions(table, charts);
  return tables;
}

}  // namespace springcheck
