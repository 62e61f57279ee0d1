#include "comparisons/results/stored_map.hpp"

#include <algorithm>
#include <set>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/results/result_file.hpp"
#include "comparisons/store/open_result_file.hpp"
#include "comparisons/store/table_rows.hpp"
#include "meshing/sha256.hpp"

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

void write_map(hid_t maps, const StoredMap& map, MapState state) {
  const std::string name = identity_of(map);
  if (state == MapState::planned && hdf5::has_link(maps, name)) return;
  hdf5::remove_link(maps, name);
  const auto group = hdf5::create_group(maps, name);
  hdf5::write_attribute(group, "scene", map.scene);
  hdf5::write_attribute(group, "first", map.axes.at(0));
  if (map.axes.size() == 2) hdf5::write_attribute(group, "second", map.axes[1]);
  hdf5::write_attribute(group, "revision", map.revision);
  if (!map.other_revisions.empty())
    hdf5::write_attribute(group, "other_revisions", map.other_revisions);
  write_rows(group, "points", map.points, [](const auto& part) { return row_of(part); });
  write_rows(group, "limits", map.limits, [](const auto& part) { return row_of(part); });
}

std::vector<StoredMap> read_maps(const std::filesystem::path& file, Revisions revisions) {
  return reading(file, [&](hid_t root) {
    std::vector<StoredMap> all;
    if (!hdf5::has_link(root, "maps")) return all;
    const auto maps = hdf5::open_group(root, "maps");
    for (const std::string& name : hdf5::links(maps))
      all.push_back(read_map(hdf5::open_group(maps, name)));
    std::set<std::string> own;
    for (const StoredMap& map : all)
      if (is_own(map)) own.insert(question_of(map));
    std::erase_if(all, [&](const StoredMap& map) {
      return !is_own(map) &&
             (revisions == Revisions::own || own.contains(question_of(map)));
    });
    return all;
  });
}

}  // namespace springcheck
