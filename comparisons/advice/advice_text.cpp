#include "comparisons/advice/advice_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "comparisons/formats/text_table.hpp"

namespace springcheck {
namespace {

constexpr std::array all_measures{ChartMeasure::force, ChartMeasure::volume,
                                  ChartMeasure::deviation};

/// "2.1 +- 0.27", of one that was not asked for in brackets.
std::string error_text(const Advice& advice, const Wish& wish, std::size_t point,
                       ChartMeasure measure) {
  const auto& error = advice.chart.points[point].errors[advice.truth].of(measure);
  if (!error) return "-";
  const auto bar = advice.chart.bar(point, measure, advice.truth);
  const std::string text =
      fmt::format("{:.3g} +- {:.2g}", 100 * *error, 100 * bar.value_or(INFINITY));
  return std::ranges::count(wish.measures, measure) > 0 ? text : "(" + text + ")";
}

std::vector<std::string> line_of(const std::string& role, const Advice& advice,
                                 const Wish& wish, std::size_t i) {
  const ChartPoint& point = advice.chart.points[i];
  std::vector<std::string> line{role, name_of(point.place.model),
                                std::to_string(point.place.across),
                                fmt::format("{:.0f}", point.place.cells)};
  for (const ChartMeasure measure : all_measures)
    line.push_back(error_text(advice, wish, i, measure));
  line.push_back(fmt::format("{:.3g}", *point.seconds()));
  if (wish.frame) {
    const auto frame = frame_of(point, *wish.frame);
    line.push_back(frame ? fmt::format("{:.0f} x {:.3g}", frame->steps, frame->dt)
                         : "none");
    line.push_back(frame ? fmt::format("{:.3g}", frame->seconds()) : "none");
  }
  line.push_back(point.place.key.substr(0, 12));
  return line;
}

/// The shortest frame that the point can hold, if there is one.
std::string words_of_frame(const ChartPoint& point) {
  constexpr double one_second = 1;  // any time of many steps
  const auto frame = frame_of(point, one_second);
  if (!frame) return {};
  const double real = frame->seconds();
  if (real > 1) return fmt::format("It is {:.3g} times slower than real time.\n", real);
  return fmt::format("It holds frames of {:.2g} s, a step each, and longer ones.\n",
                     real / frame->steps);
}

/// Where no model could be shown to meet the tolerance.
std::string words_of_bar(const Advice& advice, const Wish& wish) {
  const auto bar_is_narrower = [&](std::size_t point) {
    return std::ranges::all_of(wish.measures, [&](ChartMeasure measure) {
      return advice.chart.bar(point, measure, advice.truth).value_or(INFINITY) <
             wish.tolerance;
    });
  };
  for (std::size_t i = 0; i < advice.chart.points.size(); ++i)
    if (bar_is_narrower(i)) return {};
  return "Nothing could: the converged solution itself is not known so well. Finer grids "
         "(--converged-across) take longer.\n";
}

}  // namespace

std::string question(const Advice& advice, const Wish& wish) {
  std::vector<std::string> names;
  for (const ChartMeasure measure : wish.measures) names.emplace_back(name_of(measure));
  return fmt::format(
      "{}: {} within {:g} % of what {} converges to{}", advice.chart.stored.scene,
      fmt::join(names, ", "), 100 * wish.tolerance,
      advice.chart.truths[advice.truth].grids.law,
      wish.frame ? fmt::format(", frames of {:g} s in real time", *wish.frame) : "");
}

std::string truth_text(const Advice& advice) {
  const ChartTruth& truth = advice.chart.truths[advice.truth];
  const bool is_resolved = truth.answer.is_resolved && truth.volume_change.is_resolved;
  return fmt::format(
      "The converged solution has {} = {:.6g}, known to {:.2g} %, and a change of volume "
      "of {:.6g} of V0, known to {:.2g} % of V0 times the strain.\n{}",
      advice.chart.stored.answer, truth.answer.value, 100 * truth.bars.force.value(),
      truth.volume_change.value, 100 * truth.bars.volume.value(),
      is_resolved
          ? ""
          : "It is that unsure because two discretisations contradict each other: "
            "finer grids (--converged-across) may agree.\n");
}

std::string evidence_text(const Advice& advice, const Wish& wish) {
  TextLines lines{{"", "model", "across", "cells", "force off [%]", "volume off [%]",
                   "deviation [%]", wish.frame ? "real s per simulated s" : "time [s]"}};
  if (wish.frame) {
    lines[0].emplace_back("steps of a frame [s]");
    lines[0].emplace_back("frame takes [s]");
  }
  lines[0].emplace_back("case");
  for (const auto& [point, against] : advice.crossings)
    lines.push_back(line_of("a crossing, not chosen", advice, wish, point));
  for (const std::size_t point : advice.equals)
    lines.push_back(line_of("as quick, but larger", advice, wish, point));
  for (const auto& [role, point] :
       std::initializer_list<std::pair<const char*, std::optional<std::size_t>>>{
           {"cheaper, too far off", advice.cheaper},
           {"cannot be shown", advice.not_shown},
           {"chosen", advice.chosen},
           {"nearest", advice.nearest},
           {"dearer, more accurate", advice.dearer}})
    if (point) lines.push_back(line_of(role, advice, wish, *point));
  std::string text = in_columns(lines);
  if (!advice.crossings.empty())
    text += "\nCrossings: within the tolerance here, but not for a reason.\n";
  for (const auto& [point, against] : advice.crossings) {
    const StoredChart::Point& place = advice.chart.points[point].place;
    text += fmt::format("- {} on {} across: {}.\n", name_of(place.model), place.across,
                        against);
  }
  if (advice.not_shown)
    text += fmt::format(
        "\nThe bound of the converged solution decides of {} on {} across: finer grids "
        "(--converged-across) may show that it is accurate enough.\n",
        name_of(advice.chart.points[*advice.not_shown].place.model),
        advice.chart.points[*advice.not_shown].place.across);
  return text;
}

std::string failure_text(const Advice& advice, const Wish& wish) {
  return fmt::format("Nothing that was tried within {:g} s per solution meets it.\n{}{}",
                     wish.budget, words_of_bar(advice, wish),
                     wish.frame && advice.nearest
                         ? words_of_frame(advice.chart.points[*advice.nearest])
                         : "");
}

}  // namespace springcheck
