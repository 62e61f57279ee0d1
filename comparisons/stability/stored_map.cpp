#include "comparisons/stability/stored_map.hpp"

#include <cmath>
#include <stdexcept>

#include "comparisons/open_result_file.hpp"
#include "comparisons/store/columns.hpp"
#include "meshing/sha256.hpp"

namespace springcheck {
namespace {

void put(Row& row, const char* name, const std::optional<std::string>& text) {
  if (text && !text->empty()) row[name] = *text;
}

void put(Row& row, const char* name, const std::optional<double>& number) {
  if (number) row[name] = std::vector{*number};
}

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

template <class Part>
void write_rows(hid_t parent, const char* name, const std::vector<Part>& parts) {
  std::vector<Row> rows;
  for (const Part& part : parts) rows.push_back(row_of(part));
  append_rows(hdf5::create_group(parent, name), rows);
}

/// A table with the columns that none of its rows has.
struct MapTable {
  explicit MapTable(hid_t group) : columns(read_columns(group)) {}

  [[nodiscard]] std::optional<std::string> find(const char* name, std::size_t row) const {
    const auto column = columns.texts.find(name);
    if (column == columns.texts.end() || column->second[row].empty()) return {};
    return column->second[row];
  }

  [[nodiscard]] std::string text(const char* name, std::size_t row) const {
    auto found = find(name, row);
    if (!found) throw std::runtime_error(std::string("a map lacks a ") + name);
    return *found;
  }

  [[nodiscard]] std::optional<double> number(const char* name, std::size_t row) const {
    const auto column = columns.numbers.find(name);
    if (column == columns.numbers.end() || column->second.width != 1) return {};
    const double value = column->second.values[row];
    return std::isnan(value) ? std::nullopt : std::optional(value);
  }

  Columns columns;
};

StoredMap read_map(hid_t group) {
  StoredMap map{.scene = hdf5::read_text(group, "scene").value_or(""),
                .axes = {hdf5::read_text(group, "first").value_or("")},
                .points = {},
                .limits = {}};
  if (const auto second = hdf5::read_text(group, "second")) map.axes.push_back(*second);
  const MapTable points(hdf5::open_group(group, "points"));
  for (std::size_t i = 0; i < points.columns.rows; ++i) {
    map.points.push_back({.method = points.text("method", i),
                          .values = {points.text("first", i)},
                          .key = points.text("key", i),
                          .control = points.find("control", i)});
    if (map.axes.size() == 2)
      map.points.back().values.push_back(points.text("second", i));
  }
  const MapTable limits(hdf5::open_group(group, "limits"));
  for (std::size_t i = 0; i < limits.columns.rows; ++i)
    map.limits.push_back({.method = limits.text("method", i),
                          .other = limits.find("second", i),
                          .low = limits.number("low", i),
                          .high = limits.number("high", i),
                          .failure = limits.text("failure", i),
                          .key = limits.find("key", i)});
  return map;
}

}  // namespace

std::string identity_of(const StoredMap& map) {
  std::string text = map.scene;
  for (const std::string& axis : map.axes) text += '\n' + axis;
  for (const StoredMap::Point& point : map.points) {
    text += '\n' + point.method;
    for (const std::string& value : point.values) text += '\t' + value;
    text += '\t' + point.key;
  }
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
  write_rows(group, "points", map.points);
  write_rows(group, "limits", map.limits);
}

std::vector<StoredMap> read_maps(const std::filesystem::path& file) {
  return reading(file, [](hid_t root) {
    std::vector<StoredMap> all;
    if (!hdf5::has_link(root, "maps")) return all;
    const auto maps = hdf5::open_group(root, "maps");
    for (const std::string& name : hdf5::links(maps))
      all.push_back(read_map(hdf5::open_group(maps, name)));
    return all;
  });
}

}  // namespace springcheck
