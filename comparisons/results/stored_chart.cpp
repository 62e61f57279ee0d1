#include "comparisons/results/stored_chart.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/results/result_file.hpp"
#include "comparisons/store/open_result_file.hpp"
#include "comparisons/store/table_rows.hpp"
#include "meshing/basics/sha256.hpp"

namespace springcheck {
namespace {

/// Rounds of times as text: "0.1,0.12;0.11".
std::string text_of(const TimedRounds& times) {
  std::vector<std::string> rounds;
  for (const std::vector<double>& round : times)
    rounds.push_back(fmt::format("{}", fmt::join(round, ",")));
  return fmt::format("{}", fmt::join(rounds, ";"));
}

TimedRounds times_in(const std::string& text) {
  TimedRounds times{{}};
  const char* const end = text.data() + text.size();
  for (const char* at = text.data();; ++at) {
    double time = 0;
    const auto [stop, error] = std::from_chars(at, end, time);
    if (error != std::errc{} || !std::isnormal(time) || time < 0 ||
        (stop != end && *stop != ',' && *stop != ';'))
      throw std::runtime_error("a chart has a point of times '" + text + "'");
    times.back().push_back(time);
    if (stop == end) return times;
    if (*stop == ';') times.emplace_back();
    at = stop;
  }
}

/// The prefix of the columns of the grids that check a truth.
constexpr const char* of_check = "check_";

void put_grids(Row& row, const std::string& prefix, const StoredChart::Grids& grids) {
  for (std::size_t i = 0; i < 3; ++i) {
    put(row, fmt::format("{}size_{}", prefix, i + 1), grids.cell_sizes[i]);
    put(row, fmt::format("{}key_{}", prefix, i + 1), grids.keys[i]);
  }
  put(row, prefix + "formal_order", grids.formal_order);
}

Row row_of(const StoredChart::Truth& truth) {
  Row row{{"law", truth.law}};
  put_grids(row, "", truth.grids);
  if (truth.check) put_grids(row, of_check, *truth.check);
  put(row, "places_apart", truth.places_apart);
  return row;
}

StoredChart::Grids grids_in(const TableRows& truths, const std::string& prefix,
                            std::size_t i) {
  StoredChart::Grids grids;
  for (std::size_t grid = 0; grid < 3; ++grid) {
    grids.cell_sizes[grid] = truths.number(fmt::format("{}size_{}", prefix, grid + 1), i);
    grids.keys[grid] = truths.text(fmt::format("{}key_{}", prefix, grid + 1), i);
  }
  grids.formal_order =
      truths.find_number(prefix + "formal_order", i).value_or(least_formal_order);
  return grids;
}

StoredChart::Truth truth_in(const TableRows& truths, std::size_t i) {
  StoredChart::Truth truth{.law = truths.text("law", i),
                           .grids = grids_in(truths, "", i),
                           .places_apart = truths.find_number("places_apart", i)};
  if (truths.find_text(std::string(of_check) + "key_1", i))
    truth.check = grids_in(truths, of_check, i);
  return truth;
}

Row row_of(const Model& model) {
  Row row{{"model", name_of(model)},
          {"method", model.method},
          {"cell-type", std::string(name_of(model.cells))}};
  if (!model.element.empty()) row["element"] = model.element;
  if (!model.linear_solver.empty()) row["linear-solver"] = model.linear_solver;
  if (model.precision) row["precision"] = std::string(name_of(*model.precision));
  return row;
}

Model model_of(const TableRows& points, std::size_t i) {
  if (!points.find_text("method", i)) return model_in(points.text("model", i));
  Model model{.method = points.text("method", i),
              .element = points.find_text("element", i).value_or(""),
              .linear_solver = points.find_text("linear-solver", i).value_or("")};
  const std::string cells = points.text("cell-type", i);
  const auto type =
      std::ranges::find(all_cell_types, cells, [](CellType one) { return name_of(one); });
  if (type == all_cell_types.end())
    throw std::runtime_error("a chart has a point of cells '" + cells + "'");
  model.cells = *type;
  if (const auto name = points.find_text("precision", i)) {
    const auto* precision = find_value<dynamics::Precision>(*name);
    if (precision == nullptr)
      throw std::runtime_error("a chart has a point of precision '" + *name + "'");
    model.precision = precision->value;
  }
  return model;
}

Row row_of(const StoredChart::Point& point) {
  Row row = row_of(point.model);
  row.insert({{"kind", std::string(name_of(point.kind))}, {"key", point.key}});
  if (!point.family.empty()) row["family"] = point.family;
  put(row, "left_out", point.left_out);
  put(row, "across", point.across);
  put(row, "cells", point.cells);
  put(row, "nodes", point.nodes);
  put(row, "threads", point.threads);
  put(row, "setup", point.setup);
  put(row, "simulated", point.simulated);
  if (!point.timing) return row;
  put(row, "repetitions", point.timing->repetitions);
  put(row, "minimum", point.timing->minimum);
  put(row, "lower_quartile", point.timing->lower_quartile);
  put(row, "median", point.timing->median);
  put(row, "upper_quartile", point.timing->upper_quartile);
  put(row, "maximum", point.timing->maximum);
  if (!point.times.empty()) row["times"] = text_of(point.times);
  return row;
}

Row row_of(const StoredChart::Comparison& comparison) {
  return {{"key", comparison.key},
          {"law", comparison.law},
          {"compared", comparison.compared}};
}

ChartKind kind_named(const std::string& name) {
  if (const auto* found = find_value<ChartKind>(name)) return found->value;
  throw std::runtime_error("a chart has a point of kind '" + name + "'");
}

/// The times of a point. Older files, which keep no single times, give the median alone.
TimedRounds times_of(const TableRows& points, std::size_t i) {
  const auto median = points.find_number("median", i);
  if (!median) return {};
  const auto times = points.find_text("times", i);
  return times ? times_in(*times) : TimedRounds{{*median}};
}

StoredChart read_chart(hid_t group) {
  const auto imposed = hdf5::read_numbers(group, "imposed");
  const auto height = hdf5::read_numbers(group, "height");
  if (!height) throw std::runtime_error("a chart lacks a height");
  StoredChart chart{
      .scene = text_attribute(group, "scene", "a chart"),
      .settings = text_attribute(group, "settings", "a chart"),
      .law = text_attribute(group, "law", "a chart"),
      .answer = text_attribute(group, "answer", "a chart"),
      .height = height->at(0),
      .imposed = imposed ? std::optional(imposed->at(0)) : std::nullopt,
      .machine = hdf5::read_text(group, "machine").value_or(""),
      .revision =
          hdf5::read_text(group, "revision").value_or(std::string(unknown_revision))};
  const TableRows truths(hdf5::open_group(group, "truths"), "a chart's truth");
  for (std::size_t i = 0; i < truths.count(); ++i)
    chart.truths.push_back(truth_in(truths, i));
  const TableRows points(hdf5::open_group(group, "points"), "a chart's point");
  for (std::size_t i = 0; i < points.count(); ++i) {
    TimedRounds times = times_of(points, i);
    const auto timing = times.empty() ? std::nullopt : std::optional(timing_of(times));
    chart.points.push_back({.model = model_of(points, i),
                            .kind = kind_named(points.text("kind", i)),
                            .across = static_cast<int>(points.number("across", i)),
                            .cells = points.number("cells", i),
                            .nodes = points.number("nodes", i),
                            .threads = static_cast<int>(points.number("threads", i)),
                            .key = points.text("key", i),
                            .left_out = points.find_text("left_out", i),
                            .times = std::move(times),
                            .timing = timing,
                            .setup = points.find_number("setup", i),
                            .simulated = points.find_number("simulated", i),
                            .family = points.find_text("family", i).value_or("")});
  }
  const TableRows comparisons(hdf5::open_group(group, "comparisons"),
                              "a chart's comparison");
  for (std::size_t i = 0; i < comparisons.count(); ++i)
    chart.comparisons.push_back({.key = comparisons.text("key", i),
                                 .law = comparisons.text("law", i),
                                 .compared = comparisons.text("compared", i)});
  return chart;
}

}  // namespace

bool StoredChart::Truth::has(const std::string& key) const {
  return std::ranges::count(grids.keys, key) > 0 ||
         (check && std::ranges::count(check->keys, key) > 0);
}

std::string identity_of(const StoredChart& chart) {
  std::string text = chart.scene + '\n' + chart.settings + '\n' + chart.machine;
  for (const StoredChart::Truth& truth : chart.truths)
    if (truth.law == chart.law)
      for (const std::string& key : truth.grids.keys) text += '\n' + key;
  return sha256(text);
}

StoredChart merged(StoredChart chart, const StoredChart& other) {
  for (const StoredChart::Truth& truth : other.truths)
    if (std::ranges::count(chart.truths, truth.law, &StoredChart::Truth::law) == 0)
      chart.truths.push_back(truth);
  for (const StoredChart::Point& point : other.points) {
    StoredChart::Point* own = find_point(chart, point.model, point.key, point.threads);
    if (own == nullptr)
      chart.points.push_back(point);
    else if (!own->timing)
      *own = point;
  }
  for (const StoredChart::Comparison& comparison : other.comparisons)
    if (std::ranges::count(chart.comparisons, comparison.compared,
                           &StoredChart::Comparison::compared) == 0)
      chart.comparisons.push_back(comparison);
  return chart;
}

StoredChart::Point* find_point(StoredChart& chart, const Model& model,
                               const std::string& key, int threads) {
  const auto found = std::ranges::find_if(chart.points, [&](const auto& point) {
    return point.model == model && point.key == key && point.threads == threads;
  });
  return found == chart.points.end() ? nullptr : &*found;
}

void merge_charts(hid_t from, hid_t to) {
  for (const std::string& name : hdf5::links(from)) {
    const StoredChart theirs = read_chart(hdf5::open_group(from, name));
    const std::string own = identity_of(theirs);
    write_chart(to, hdf5::has_link(to, own)
                        ? merged(read_chart(hdf5::open_group(to, own)), theirs)
                        : theirs);
  }
}

void write_chart(hid_t charts, const StoredChart& chart) {
  const std::string name = identity_of(chart);
  hdf5::remove_link(charts, name);
  const auto group = hdf5::create_group(charts, name);
  hdf5::write_attribute(group, "scene", chart.scene);
  hdf5::write_attribute(group, "settings", chart.settings);
  hdf5::write_attribute(group, "law", chart.law);
  hdf5::write_attribute(group, "answer", chart.answer);
  hdf5::write_attribute(group, "height", chart.height);
  if (chart.imposed) hdf5::write_attribute(group, "imposed", *chart.imposed);
  hdf5::write_attribute(group, "machine", chart.machine);
  hdf5::write_attribute(group, "revision", chart.revision);
  write_rows(group, "truths", chart.truths,
             [](const auto& part) { return row_of(part); });
  write_rows(group, "points", chart.points,
             [](const auto& part) { return row_of(part); });
  write_rows(group, "comparisons", chart.comparisons,
             [](const auto& part) { return row_of(part); });
}

std::vector<StoredChart> read_charts(const std::filesystem::path& file,
                                     Revisions revisions) {
  return reading(file, [&](hid_t root) {
    auto all = read_groups(root, "charts", read_chart);
    if (revisions == Revisions::own)
      std::erase_if(all, [](const StoredChart& chart) {
        return chart.revision != build_info::revision;
      });
    std::ranges::stable_sort(all, [](const StoredChart& a, const StoredChart& b) {
      return a.scene != b.scene ? a.scene < b.scene : a.points.size() > b.points.size();
    });
    return all;
  });
}

}  // namespace springcheck
