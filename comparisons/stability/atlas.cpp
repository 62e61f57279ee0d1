#include "comparisons/stability/atlas.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <ranges>
#include <set>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/stability/atlas_cases.hpp"
#include "comparisons/stability/atlas_limits.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

/// Throws InputError for an axis that no case reads: its cases are all the same.
void check_axes(const Atlas& atlas, const AtlasPlan& plan) {
  for (std::size_t axis = 0; axis < plan.axes.size(); ++axis) {
    std::map<std::pair<std::string, std::string>, std::set<std::string>> keys;
    for (const AtlasPoint& point : atlas.points) {
      const std::string other = point.values.size() > 1 ? point.values[1 - axis] : "";
      const std::string method = point.method.substr(0, point.method.find(':'));
      keys[{method, other}].insert(point.result.key);  // an axis may be of elements
    }
    if (plan.axes[axis].values.size() > 1 &&
        std::ranges::all_of(keys,
                            [](const auto& line) { return line.second.size() == 1; }))
      throw InputError("--over " + plan.axes[axis].key, "",
                       "a setting that these methods and this solver read",
                       "one that changes no case");
  }
}

/// The atlas as files keep it; the results of its points may still be lacking.
StoredMap stored_map(const Atlas& atlas, const AtlasPlan& plan,
                     const OtherRevisions& others, MapState state) {
  StoredMap map{.scene = plan.scene, .revision = build_info::revision, .state = state};
  map.other_revisions = fmt::format("{}", fmt::join(others | std::views::keys, ","));
  for (const Axis& axis : plan.axes) map.axes.push_back(axis.key);
  for (const AtlasPoint& point : atlas.points)
    map.points.push_back({.method = point.method,
                          .values = point.values,
                          .key = point.result.key,
                          .control = point.control});
  for (const AtlasLimit& limit : atlas.limits)
    map.limits.push_back(
        {.method = limit.method,
         .other = limit.other,
         .low = limit.low,
         .high = limit.high,
         .failure = std::string(name_of(limit.failure)),
         .key = limit.cases.empty() ? std::nullopt : std::optional(limit.cases[0])});
  return map;
}

}  // namespace

Atlas make_atlas(const AtlasPlan& plan, CaseRunner& runner) {
  std::vector<std::vector<std::string>> places;
  for (const std::string& first : plan.axes[0].values) {
    if (plan.axes.size() == 1) places.push_back({first});
    if (plan.axes.size() == 2)
      for (const std::string& second : plan.axes[1].values)
        places.push_back({first, second});
  }
  std::vector<CaseSettings> cases;
  Atlas atlas;
  for (const auto& values : places)
    for (const CaseSettings& settings : cases_at(plan, values)) {
      cases.push_back(settings);
      atlas.points.push_back(
          {.method = label(settings), .values = values, .failure = Failure::none});
    }
  std::vector<Request> requests;
  for (const CaseSettings& settings : cases) requests.push_back({.settings = settings});
  check_memory("--over", requests);
  const std::vector<std::string> keys = runner.keys_of(cases);
  for (std::size_t i = 0; i < keys.size(); ++i) atlas.points[i].result.key = keys[i];
  check_axes(atlas, plan);
  // The map is kept before it is filled, which may be interrupted.
  runner.keep(stored_map(atlas, plan, runner.others(), MapState::planned));
  std::vector<CaseResult> results = runner.run(cases);
  std::map<std::size_t, std::string> controls;
  const std::vector<Failure> failures = failures_of(plan, runner, results, &controls);
  for (std::size_t i = 0; i < results.size(); ++i) {
    AtlasPoint& point = atlas.points[i];
    point.failure = failures[i];
    point.result = std::move(results[i]);
    if (const auto control = controls.find(i); control != controls.end())
      point.control = control->second;
  }
  if (plan.axes[0].is_range) atlas.limits = limits_of(atlas, plan, runner);
  runner.keep(stored_map(atlas, plan, runner.others(), MapState::complete));
  return atlas;
}

}  // namespace springcheck
