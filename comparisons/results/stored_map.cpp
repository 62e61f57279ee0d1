#include "comparisons/results/stored_map.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/results/result_file.hpp"
#include "comparisons/store/open_result_file.hpp"
#include "comparisons/store/stored_columns.hpp"
#include "comparisons/store/table_rows.hpp"
#include "meshing/basics/sha256.hpp"

namespace springcheck {
namespace {

Row row_of(const StoredMap::Point& point) {
  Row row{{"method", point.method}, {"first", point.values.at(0)}, {"key", point.key}};
  if (point.values.size() == 2) put(row, "second", point.values[1]);
  put(row, "control", point.control);
  return row;
}

Row row_of(const StoredMap::Limit& limit) {
  Row row{{"method", limit.method}, {"failure", limit.failure}};
  put(row, "second", limit.other);
  put(row, "low", limit.low);
  put(row, "high", limit.high);
  put(row, "key", limit.key);
  return row;
}

StoredMap read_map(hid_t group) {
  StoredMap map{
      .scene = text_attribute(group, "scene", "a map"),
      .axes = {text_attribute(group, "first", "a map")},
      .revision =
          hdf5::read_text(group, "revision").value_or(std::string(unknown_revision)),
      .other_revisions = hdf5::read_text(group, "other_revisions").value_or("")};
  if (hdf5::read_numbers(group, "complete")) map.state = MapState::complete;
  if (hdf5::read_text(group, "second"))
    map.axes.push_back(text_attribute(group, "second", "a map"));
  const TableRows points(hdf5::open_group(group, "points"), "a map");
  for (std::size_t i = 0; i < points.count(); ++i) {
    map.points.push_back({.method = points.text("method", i),
                          .values = {points.text("first", i)},
                          .key = points.text("key", i),
                          .control = points.find_text("control", i)});
    if (map.axes.size() == 2)
      map.points.back().values.push_back(points.text("second", i));
  }
  const TableRows limits(hdf5::open_group(group, "limits"), "a map");
  for (std::size_t i = 0; i < limits.count(); ++i)
    map.limits.push_back({.method = limits.text("method", i),
                          .other = limits.find_text("second", i),
                          .low = limits.find_number("low", i),
                          .high = limits.find_number("high", i),
                          .failure = limits.text("failure", i),
                          .key = limits.find_text("key", i)});
  return map;
}

/// What a map was asked, whatever came of it.
std::string question_of(const StoredMap& map) {
  std::string text = map.scene;
  for (const std::string& axis : map.axes) text += '\n' + axis;
  for (const StoredMap::Point& point : map.points) {
    text += '\n' + point.method;
    for (const std::string& value : point.values) text += '\t' + value;
  }
  return text;
}

bool is_own(const StoredMap& map) {
  return revisions_of(map).empty();
}

}  // namespace

std::string revisions_of(const StoredMap& map) {
  const std::string own = map.revision == build_info::revision ? "" : map.revision;
  return own + (own.empty() || map.other_revisions.empty() ? "" : ",") +
         map.other_revisions;
}

std::string identity_of(const StoredMap& map) {
  std::string text = question_of(map) + '\n' + map.revision;
  for (const StoredMap::Point& point : map.points) text += '\n' + point.key;
  return sha256(text);
}

void write_map(hid_t maps, const StoredMap& map) {
  const std::string name = identity_of(map);
  if (map.state == MapState::planned && hdf5::has_link(maps, name)) return;
  hdf5::remove_link(maps, name);
  if (map.state == MapState::complete)
    for (const std::string& other : hdf5::links(maps)) {
      const StoredMap earlier = read_map(hdf5::open_group(maps, other));
      if (earlier.state == MapState::planned && earlier.revision == map.revision &&
          question_of(earlier) == question_of(map))
        hdf5::remove_link(maps, other);
    }
  const auto group = hdf5::create_group(maps, name);
  hdf5::write_attribute(group, "scene", map.scene);
  hdf5::write_attribute(group, "first", map.axes.at(0));
  if (map.axes.size() == 2) hdf5::write_attribute(group, "second", map.axes[1]);
  hdf5::write_attribute(group, "revision", map.revision);
  if (!map.other_revisions.empty())
    hdf5::write_attribute(group, "other_revisions", map.other_revisions);
  if (map.state == MapState::complete) hdf5::write_attribute(group, "complete", 1.);
  write_rows(group, "points", map.points, [](const auto& part) { return row_of(part); });
  write_rows(group, "limits", map.limits, [](const auto& part) { return row_of(part); });
}

void merge_maps(hid_t from, hid_t to) {
  for (const std::string& name : hdf5::links(from)) {
    const StoredMap map = read_map(hdf5::open_group(from, name));
    const bool is_known = hdf5::has_link(to, identity_of(map));
    if (!is_known ||
        (map.state == MapState::complete &&
         read_map(hdf5::open_group(to, identity_of(map))).state == MapState::planned))
      write_map(to, map);
  }
}

namespace {

/// Latest date of each revision's sessions.
std::map<std::string, std::string> dates_of_revisions(hid_t root) {
  const auto provenance = hdf5::open_group(root, "provenance");
  const auto revisions = read_texts(provenance, "revision"),
             dates = read_texts(provenance, "date");
  std::map<std::string, std::string> latest;
  for (std::size_t i = 0; i < std::min(revisions.size(), dates.size()); ++i)
    latest[revisions[i]] = std::max(latest[revisions[i]], dates[i]);
  return latest;
}

}  // namespace

std::vector<StoredMap> read_maps(const std::filesystem::path& file, Revisions revisions) {
  return reading(file, [&](hid_t root) {
    auto all = read_groups(root, "maps", read_map);
    if (revisions == Revisions::own) {
      std::erase_if(all, [](const StoredMap& map) { return !is_own(map); });
      return all;
    }
    const auto dates = dates_of_revisions(root);
    const auto rank = [&](const StoredMap& map) {  // the highest is taken
      const auto date = dates.find(map.revision);
      return std::tuple(map.state == MapState::complete, is_own(map),
                        date == dates.end() ? "" : date->second, identity_of(map));
    };
    std::map<std::string, std::size_t> best;  // places of all, by question
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto [place, is_new] = best.try_emplace(question_of(all[i]), i);
      if (!is_new && rank(all[i]) > rank(all[place->second])) place->second = i;
    }
    std::vector<StoredMap> taken;
    for (const auto& [question, place] : best) taken.push_back(std::move(all[place]));
    return taken;
  });
}

}  // namespace springcheck
