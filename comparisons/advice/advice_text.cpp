#include "comparisons/advice/advice_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace springcheck {
namespace {

constexpr std::array all_measures{ChartMeasure::force, ChartMeasure::volume,
                                  ChartMeasure::deviation};

std::vector<std::string_view> names_of(const std::vector<ChartMeasure>& measures) {
  std::vector<std::string_view> names;
  for (const ChartMeasure measure : measures) names.push_back(name_of(measure));
  return names;
}

std::optional<double> in_percent(const std::optional<double>& fraction) {
  return fraction ? std::optional(100 * *fraction) : std::nullopt;
}

std::vector<Column> columns_of(const Wish& wish) {
  std::vector<Column> columns{{.key = "role", .heading = "role"},
                              {.key = "model", .heading = "model"},
                              {.key = "across", .heading = "across", .format = "{:.0f}"},
                              {.key = "cells", .heading = "cells", .format = "{:.0f}"}};
  for (const ChartMeasure measure : all_measures) {
    const std::string name(name_of(measure));
    columns.push_back({.key = name, .heading = name + " off [%]", .format = "{:.3g}"});
    columns.push_back(
        {.key = name + "_bound", .heading = name + " +- [%]", .format = "{:.2g}"});
  }
  columns.push_back({.key = "seconds",
                     .heading = wish.frame ? "real s per simulated s" : "time [s]",
                     .format = "{:.3g}"});
  if (!wish.frame) return columns;
  columns.push_back({.key = "steps", .heading = "steps of a frame", .format = "{:.0f}"});
  columns.push_back({.key = "step_seconds", .heading = "step [s]", .format = "{:.3g}"});
  columns.push_back(
      {.key = "frame_seconds", .heading = "frame takes [s]", .format = "{:.3g}"});
  return columns;
}

TableRow row_of(const std::string& role, const Advice& advice, const Wish& wish,
                std::size_t i) {
  const ChartPoint& point = advice.chart.points[i];
  TableRow row{
      .cells = {role, name_of(point.place.model), point.place.across, point.place.cells},
      .cases = {point.place.key}};
  for (const ChartMeasure measure : all_measures) {
    const auto& error = point.errors[advice.truth].of(measure);
    row.cells.emplace_back(in_percent(error));
    row.cells.emplace_back(
        error ? in_percent(advice.chart.error_bound(i, measure, advice.truth))
              : std::nullopt);
  }
  row.cells.emplace_back(point.seconds());
  if (wish.frame) {
    const auto frame = frame_of(point, *wish.frame);
    row.cells.push_back(frame ? Cell(frame->steps) : Cell(std::nullopt, "none"));
    row.cells.push_back(frame ? Cell(frame->dt) : Cell());
    row.cells.push_back(frame ? Cell(frame->seconds()) : Cell(std::nullopt, "none"));
  }
  return row;
}

/// The shortest frame that the point can hold, if there is one.
std::string words_of_frame(const ChartPoint& point) {
  constexpr double one_second = 1;  // any time of many steps
  const auto frame = frame_of(point, one_second);
  if (!frame) return {};
  const double real = frame->seconds();
  if (real > 1) return fmt::format(" It is {:.3g} times slower than real time.", real);
  return fmt::format(" It holds frames of {:.2g} s, a step each, and longer ones.",
                     real / frame->steps);
}

/// Says that no model could have been shown to meet the tolerance, since the error bounds
/// of the truth are too wide; empty where they are not.
std::string words_of_error_bound(const Advice& advice, const Wish& wish) {
  const auto bound_is_narrower = [&](std::size_t point) {
    return std::ranges::all_of(wish.measures, [&](ChartMeasure measure) {
      return advice.chart.error_bound(point, measure, advice.truth).value_or(INFINITY) <
             wish.tolerance;
    });
  };
  for (std::size_t i = 0; i < advice.chart.points.size(); ++i)
    if (bound_is_narrower(i)) return {};
  return " Nothing could: the converged solution itself is not known so well. Finer "
         "grids (--converged-across) take longer.";
}

}  // namespace

std::string question(const Advice& advice, const Wish& wish) {
  return fmt::format(
      "{}: {} within {:g} % of what {} converges to{}", advice.chart.stored.scene,
      fmt::join(names_of(wish.measures), ", "), 100 * wish.tolerance,
      advice.chart.truths[advice.truth].grids.law,
      wish.frame ? fmt::format(", frames of {:g} s in real time", *wish.frame) : "");
}

std::string truth_text(const Advice& advice) {
  const ChartTruth& truth = advice.chart.truths[advice.truth];
  const bool is_resolved = truth.answer.is_resolved && truth.volume_change.is_resolved;
  return fmt::format(
      "The converged solution has {} = {:.6g}, known to {:.2g} %, and a change of volume "
      "of {:.6g} of V0, known to {:.2g} % of V0 times the strain.{}",
      advice.chart.stored.answer, truth.answer.value,
      100 * truth.error_bounds.force.value(), truth.volume_change.value,
      100 * truth.error_bounds.volume.value(),
      is_resolved
          ? ""
          : " It is that unsure because two discretisations contradict each other: "
            "finer grids (--converged-across) may agree.");
}

Table evidence_table(const Advice& advice, const Wish& wish) {
  Table table{
      .name = "advice",
      .title = question(advice, wish),
      .columns = columns_of(wish),
      .in_json = {{"measures", names_of(wish.measures)}, {"tolerance", wish.tolerance}}};
  const auto add = [&](const std::string& role, std::size_t point) {
    table.rows.push_back(row_of(role, advice, wish, point));
  };
  for (const auto& [point, against] : advice.crossings)
    add("a crossing, not chosen", point);
  for (const std::size_t point : advice.equals) add("as quick, but larger", point);
  for (const auto& [role, point] :
       std::initializer_list<std::pair<const char*, std::optional<std::size_t>>>{
           {"cheaper, too far off", advice.cheaper},
           {"cannot be shown", advice.not_shown},
           {"chosen", advice.chosen},
           {"nearest", advice.nearest},
           {"dearer, more accurate", advice.dearer}})
    if (point) add(role, *point);
  return table;
}

std::vector<std::string> notes_on_evidence(const Advice& advice) {
  std::vector<std::string> notes;
  if (!advice.crossings.empty())
    notes.emplace_back("Crossings: within the tolerance here, but not for a reason.");
  for (const auto& [point, against] : advice.crossings) {
    const StoredChart::Point& place = advice.chart.points[point].place;
    notes.push_back(fmt::format("- {} on {} across: {}.", name_of(place.model),
                                place.across, against));
  }
  if (advice.not_shown)
    notes.push_back(fmt::format(
        "The bound of the converged solution decides of {} on {} across: finer grids "
        "(--converged-across) may show that it is accurate enough.",
        name_of(advice.chart.points[*advice.not_shown].place.model),
        advice.chart.points[*advice.not_shown].place.across));
  return notes;
}

std::string failure_text(const Advice& advice, const Wish& wish) {
  return fmt::format("Nothing that was tried within {:g} s per solution meets it.{}{}",
                     wish.budget, words_of_error_bound(advice, wish),
                     wish.frame && advice.nearest
                         ? words_of_frame(advice.chart.points[*advice.nearest])
                         : "");
}

}  // namespace springcheck
