#include "comparisons/chart/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "comparisons/chart/pareto.hpp"
#include "comparisons/methods/methods.hpp"

namespace springcheck {
namespace {

constexpr int counted_threads = 1;

bool is_of_springs(const ChartPoint& point) {
  return family_of(point.place) == name_of(Family::springs);
}

/// Whether a took less time than b.
Answer faster(const ChartPoint& a, const ChartPoint& b) {
  if (a.is_faster_than(b)) return Answer::yes;
  if (b.is_faster_than(a)) return Answer::no;
  return Answer::undecided;
}

/// The points of the two models on the same cells, as many as both hold on; none where
/// they nowhere do.
std::optional<std::pair<std::size_t, std::size_t>> same_cells(
    const Chart& chart, const Model& springs, const Model& elements,
    const std::function<bool(const ChartPoint&)>& counts) {
  std::optional<std::pair<std::size_t, std::size_t>> best;
  for (std::size_t i = 0; i < chart.points.size(); ++i)
    for (std::size_t j = 0; j < chart.points.size(); ++j) {
      const ChartPoint &a = chart.points[i], &b = chart.points[j];
      const bool fits = a.place.model == springs && b.place.model == elements &&
                        a.place.across == b.place.across && counts(a) && counts(b);
      if (fits && (!best || a.place.across > chart.points[best->first].place.across))
        best = {i, j};
    }
  return best;
}

/// A point's error, which is at least what the truth may be off: errors below that tell
/// nothing.
struct KnownError {
  double value;
  bool is_bound;
};

KnownError known_error(const Chart& chart, ChartMeasure measure, std::size_t i) {
  const std::size_t truth = *chart.truth_of(chart.stored.law);
  const double error_bound = chart.error_bound(i, measure, truth).value_or(0);
  const double error = *chart.points[i].errors[truth].of(measure);
  return {.value = std::max(error, error_bound), .is_bound = error < error_bound};
}

/// Whether a is closer to the truth than b, by a worthwhile gain and more than what the
/// truth may be off.
Answer closer(const Chart& chart, ChartMeasure measure, std::size_t a, std::size_t b) {
  const std::size_t truth = *chart.truth_of(chart.stored.law);
  const double one = known_error(chart, measure, a).value,
               other = known_error(chart, measure, b).value;
  const double known_to = std::max({chart.error_bound(a, measure, truth).value_or(0),
                                    chart.error_bound(b, measure, truth).value_or(0),
                                    worthwhile_gain * std::max(one, other)});
  if (std::abs(one - other) <= known_to) return Answer::undecided;
  return one < other ? Answer::yes : Answer::no;
}

Claim claim_of(const Chart& chart, ChartKind kind, ChartMeasure measure,
               std::size_t springs, std::size_t elements,
               const std::function<bool(const ChartPoint&)>& counts) {
  Claim claim{.kind = kind,
              .measure = measure,
              .springs = springs,
              .elements = elements,
              .is_faster = faster(chart.points[springs], chart.points[elements]),
              .is_as_accurate = closer(chart, measure, springs, elements),
              .were_all_run = true,
              .is_faster_at_equal_accuracy = Answer::undecided};
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    const ChartPoint& point = chart.points[i];
    if (point.place.kind != kind || is_of_springs(point)) continue;
    if (point.place.threads == counted_threads && !point.seconds())
      claim.were_all_run = false;
    if (!counts(point) || closer(chart, measure, springs, i) == Answer::yes) continue;
    if (!claim.rival || *point.seconds() < *chart.points[*claim.rival].seconds())
      claim.rival = i;
  }
  if (claim.rival)
    claim.is_faster_at_equal_accuracy =
        faster(chart.points[springs], chart.points[*claim.rival]);
  else if (claim.were_all_run)
    claim.is_faster_at_equal_accuracy = Answer::yes;
  return claim;
}

/// A point of a claim with its figures: "mss-cf on 10 across (0.21 s, 4.2 % off)".
std::string figures(const Chart& chart, const Claim& claim, std::size_t i) {
  const ChartPoint& point = chart.points[i];
  const KnownError error = known_error(chart, claim.measure, i);
  return fmt::format("{} on {} across ({}, {}{:.3g} % off)", name_of(point.place.model),
                     point.place.across, time_text(point),
                     error.is_bound ? "less than " : "", 100 * error.value);
}

std::string times_as(double ratio, const char* more, const char* less) {
  return ratio >= 1 ? fmt::format("{:.3g} times {}", ratio, more)
                    : fmt::format("{:.3g} times {}", 1 / ratio, less);
}

}  // namespace

std::vector<Claim> claims(const Chart& chart) {
  const auto truth = chart.truth_of(chart.stored.law);
  if (!truth) return {};
  struct Pair {
    ChartKind kind;
    Model springs, elements;
  };
  constexpr auto precision = dynamics::Precision::double_precision;
  std::vector<Pair> pairs;
  for (const Method* springs : foremost(Family::springs)) {
    if (!springs->same_law_as.empty() && springs->same_law_as != chart.stored.law)
      continue;
    pairs.push_back({ChartKind::equilibrium,
                     {.method = springs->name},
                     {.method = chart.stored.law, .element = "q1-sri"}});
    for (const Model& elements : moving_elements(CellType::hexahedron, precision))
      pairs.push_back({ChartKind::motion,
                       {.method = springs->name, .precision = precision},
                       elements});
  }
  std::vector<Claim> all;
  for (const auto& [kind, springs, elements] : pairs)
    for (const ChartMeasure measure : all_values<ChartMeasure>()) {
      const auto counts = [&](const ChartPoint& point) {
        return point.is_ok() && point.seconds() &&
               point.place.threads == counted_threads && point.errors[*truth].of(measure);
      };
      if (const auto pair = same_cells(chart, springs, elements, counts))
        all.push_back(claim_of(chart, kind, measure, pair->first, pair->second, counts));
    }
  return all;
}

std::string claim_text(const Chart& chart, const Claim& claim) {
  const ChartPoint& springs = chart.points[claim.springs];
  const ChartPoint& elements = chart.points[claim.elements];
  const auto error = [&](std::size_t i) {
    return known_error(chart, claim.measure, i).value;
  };
  std::string text = figures(chart, claim, claim.springs) +
                     (claim.is_faster == Answer::undecided
                          ? ": whether that is faster the times do not tell, than "
                          : fmt::format(" is {} than ",
                                        times_as(*elements.seconds() / *springs.seconds(),
                                                 "faster", "slower"))) +
                     figures(chart, claim, claim.elements) + " and ";
  text += claim.is_as_accurate == Answer::undecided
              ? "as far off, within 1 % or what the converged solution is known to. "
              : times_as(error(claim.springs) / error(claim.elements), "as far off.",
                         "closer.") +
                    " ";
  if (!claim.rival)
    return text + "No finite elements of the chart are as accurate as it" +
           (claim.were_all_run ? "." : "; some of them were not run.");
  if (claim.is_faster_at_equal_accuracy == Answer::undecided)
    return text + "Not less accurate is " + figures(chart, claim, *claim.rival) +
           "; which is faster the times do not tell.";
  const ChartPoint& rival = chart.points[*claim.rival];
  return text +
         fmt::format("Not less accurate is {}, {}.", figures(chart, claim, *claim.rival),
                     times_as(*springs.seconds() / *rival.seconds(), "faster", "slower"));
}

Table claims_table(const std::vector<Chart>& charts) {
  Table table{
      .name = "chart-claims",
      .title = "Are springs faster than finite elements, and as accurate?",
      .columns = {{"scene", "scene"},
                  {"kind", "kind"},
                  {"law", "law"},
                  {"measure", "measure"},
                  {"springs", "springs"},
                  {"faster", "faster on the same cells"},
                  {"as_accurate", "as accurate there"},
                  {"faster_at_equal_accuracy", "faster at equal accuracy"},
                  {"words", "by the figures"}},
      .notes = {
          "Against what the scene's own law converges to, on one thread, on the largest "
          "mesh "
          "that both hold on. Undecided: the times cannot be told apart, as chart-front "
          "says, or the errors differ by less than 1 %, or than the converged solution's "
          "bound. At "
          "equal accuracy: beside the fastest finite elements of the chart, of any law, "
          "cells, precision and size, that cannot be told to be less accurate; where "
          "there are none, yes, but undecided where some were left out, over budget or "
          "memory, or not applicable. An error below that bound counts as "
          "that."}};
  for (const Chart& chart : charts)
    for (const Claim& claim : claims(chart)) {
      const ChartPoint& springs = chart.points[claim.springs];
      TableRow row{
          .cells = {}, .cases = {springs.place.key}, .part = identity_of(chart.stored)};
      for (const std::string& text :
           {chart.stored.scene, std::string(name_of(claim.kind)), chart.stored.law,
            std::string(name_of(claim.measure)), name_of(springs.place.model),
            std::string(name_of(claim.is_faster)),
            std::string(name_of(claim.is_as_accurate)),
            std::string(name_of(claim.is_faster_at_equal_accuracy)),
            claim_text(chart, claim)})
        row.cells.push_back(text);
      row.cases.push_back(chart.points[claim.elements].place.key);
      if (claim.rival) row.cases.push_back(chart.points[*claim.rival].place.key);
      table.rows.push_back(std::move(row));
    }
  return table;
}

}  // namespace springcheck
