#include "comparisons/stability/atlas_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

#include "comparisons/results/known_results.hpp"
#include "comparisons/results/stored_map.hpp"
#include "comparisons/stability/axis.hpp"
#include "comparisons/stability/failure.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;
using Stored = std::map<std::string, StoredCase>;

template <class Value>
Json value_or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json axis_json(const StoredMap& map, std::size_t place) {
  std::vector<std::string> values;
  for (const StoredMap::Point& point : map.points)
    if (std::ranges::count(values, point.values[place]) == 0)
      values.push_back(point.values[place]);
  const Axis axis = axis_of(map.axes[place], values);
  Json json{{"key", axis.key}, {"values", values}, {"numbers", nullptr}, {"unit", ""}};
  if (!axis.is_range) return json;
  json["unit"] = unit_of(values.front());
  json["numbers"] = Json::array();
  for (const std::string& value : values) json["numbers"].push_back(number_of(value));
  return json;
}

CaseResult result_of(const StoredCase& stored) {
  return with_stored(Request{}, stored);
}

Json failure_json(const StoredMap::Point& point, const Stored& stored) {
  const auto found = stored.find(point.key);
  if (found == stored.end()) return nullptr;
  const CaseResult result = result_of(found->second);
  Failure failure = failure_of(result);
  if (failure == Failure::none && point.control)
    if (const auto control = stored.find(*point.control); control != stored.end())
      if (locks(result, result_of(control->second))) failure = Failure::locking;
  return std::string(name_of(failure));
}

Json map_json(const StoredMap& map, const Stored& stored) {
  Json json{{"scene", map.scene},
            {"other_revisions", revisions_of(map)},
            {"axes", Json::array()}};
  for (std::size_t place = 0; place < map.axes.size(); ++place)
    json["axes"].push_back(axis_json(map, place));
  json["points"] = Json::array();
  for (const StoredMap::Point& point : map.points)
    json["points"].push_back({{"method", point.method},
                              {"values", point.values},
                              {"case", point.key},
                              {"failure", failure_json(point, stored)}});
  json["limits"] = Json::array();
  for (const StoredMap::Limit& limit : map.limits)
    json["limits"].push_back({{"method", limit.method},
                              {"other", value_or_null(limit.other)},
                              {"low", value_or_null(limit.low)},
                              {"high", value_or_null(limit.high)},
                              {"failure", limit.failure},
                              {"case", value_or_null(limit.key)}});
  return json;
}

}  // namespace

Json atlas_json(const std::filesystem::path& file, Revisions revisions) {
  Json failures = Json::array();
  for (const FailureName& failure : value_names<Failure>)
    failures.push_back(
        {{"name", failure.name}, {"letter", std::string(1, failure.letter)}});
  std::vector<StoredMap> maps = read_maps(file, revisions);
  std::ranges::sort(maps, {}, [](const StoredMap& map) {
    return std::tuple(map.scene, map.axes, identity_of(map));
  });
  Json list = Json::array();
  if (!maps.empty()) {
    const Stored stored = results_by_stored_key(file);
    for (const StoredMap& map : maps) list.push_back(map_json(map, stored));
  }
  return {{"failures", failures}, {"maps", list}};
}

}  // namespace springcheck
