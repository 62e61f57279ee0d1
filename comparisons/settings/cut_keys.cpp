#include "comparisons/settings/cut_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <ranges>

#include "comparisons/names/suggestion.hpp"
#include "comparisons/settings/named_values.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

constexpr ValueType name_text = type_of<std::string>(),
                    points = type_of<std::vector<double>>();
template <std::size_t n>
constexpr ValueType coordinates = type_of<std::array<double, n>>();

/// The keys that say along what a cut goes, of which each cut has one.
constexpr std::array surfaces{"plane", "box", "cylinder", "polyline"};

/// The values of one cut by their keys, and where it stands.
struct Written {
  std::string place;
  std::map<std::string, Given, std::less<>> values;

  [[nodiscard]] const Given* find(std::string_view key) const {
    const auto found = values.find(key);
    return found == values.end() ? nullptr : &found->second;
  }
};

void add(Written& cut, const std::string& key, const Given& value) {
  std::vector<std::string_view> names;
  for (const CutKey& known : cut_keys()) names.push_back(known.name);
  const auto known = std::ranges::find(cut_keys(), key, &CutKey::name);
  if (known == cut_keys().end()) refuse_name(value.place(), "key of a cut", key, names);
  const Dimension dimension =
      holds_numbers(known->type) ? Dimension::length : Dimension::none;
  if (!cut.values.emplace(key, value.in_si_units(dimension)).second)
    value.refuse(fmt::format("{} once", key));
}

std::vector<Written> written_in_tables(const Given& given) {
  std::vector<Written> cuts;
  for (const Given::Table& table : given.tables("[[cut]] tables, or text")) {
    Written& cut = cuts.emplace_back();
    cut.place = table.place + ": cut";
    for (const auto& [key, value] : *table.entries) add(cut, key, value);
  }
  return cuts;
}

std::string_view trimmed(std::string_view word) {
  while (word.starts_with(' ')) word.remove_prefix(1);
  while (word.ends_with(' ')) word.remove_suffix(1);
  return word;
}

/// Words between commas: a kind begins a cut, KEY=VALUE a value, which further ones
/// continue.
std::vector<Written> written_in_text(const std::string& place, const std::string& all) {
  std::vector<Written> cuts;
  if (trimmed(all).empty()) return cuts;
  std::string key, value;
  const auto end_value = [&] {
    if (!key.empty())
      add(cuts.back(), key, Given::from_text(fmt::format("{}: {}", place, key), value));
    key.clear();
  };
  for (const auto part : std::views::split(all, ',')) {
    const std::string_view word = trimmed({part.begin(), part.end()});
    const std::size_t equals = word.find('=');
    if (equals != std::string_view::npos && !cuts.empty()) {
      end_value();
      key = trimmed(word.substr(0, equals));
      value = trimmed(word.substr(equals + 1));
    } else if (std::ranges::count(all_names<CutKind>(), word) > 0) {
      end_value();
      cuts.emplace_back().place = place;
      add(cuts.back(), "kind", Given(place, Given::Scalar(std::string(word))));
    } else if (!key.empty()) {
      value += fmt::format(",{}", word);
    } else {
      if (equals != std::string_view::npos)
        throw InputError(place, "", "split or remove, with which a cut begins",
                         fmt::format("'{}'", word));
      refuse_name(place, "kind of cut", word, all_names<CutKind>());
    }
  }
  end_value();
  return cuts;
}

Vector3 vector_at(const auto& numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

Plane plane_of(const Given& given) {
  const auto n = given.numbers<4>();
  const Vector3 normal = vector_at(n, 0);
  double length = normal.stableNorm();
  if (!(length > 0)) given.refuse("a normal other than zero, and an offset");
  constexpr double rounding = 1e-15;  // what is of unit length stays, digit by digit
  if (std::abs(length - 1) < rounding) length = 1;
  return {.normal = normal / length, .offset = n[3] / length};
}

Box box_of(const Given& given) {
  const auto n = given.numbers<6>();
  const Box box{.low = vector_at(n, 0), .high = vector_at(n, 3)};
  if (!(box.low.array() < box.high.array()).all())
    given.refuse("its lower corner x,y,z, and above it its upper one");
  return box;
}

Cylinder cylinder_of(const Given& given) {
  const auto n = given.numbers<7>();
  const Cylinder cylinder{.from = vector_at(n, 0), .to = vector_at(n, 3), .radius = n[6]};
  if (cylinder.from == cylinder.to || !(cylinder.radius > 0))
    given.refuse("the ends x,y,z of its axis, apart, and a radius above 0");
  return cylinder;
}

Blade blade_of(const Given& way, const Given& depth) {
  const std::vector<double> n = way.any_numbers();
  if (n.size() < 6 || n.size() % 3 != 0)
    way.refuse("x,y,z of each of two or more points");
  Blade blade{.points = {}, .depth = vector_at(depth.numbers<3>(), 0)};
  for (std::size_t i = 0; i < n.size(); i += 3) blade.points.push_back(vector_at(n, i));
  constexpr double least_sine = 1e-3;
  for (std::size_t i = 1; i < blade.points.size(); ++i) {
    const Vector3 stretch = blade.points[i] - blade.points[i - 1];
    if (stretch.isZero(0)) way.refuse("points that are each apart from the next");
    if (!(stretch.cross(blade.depth).norm() >
          least_sine * stretch.norm() * blade.depth.norm()))
      depth.refuse("a vector other than zero, and across the polyline");
  }
  return blade;
}

CuttingSurface surface_of(const Written& cut) {
  const Given* chosen = nullptr;
  std::string_view name;
  for (const std::string_view key : surfaces) {
    const Given* given = cut.find(key);
    if (given == nullptr) continue;
    if (chosen != nullptr) given->refuse(fmt::format("no {} beside {}", key, name));
    chosen = given;
    name = key;
  }
  if (chosen == nullptr)
    throw InputError(cut.place, "", fmt::format("one of {}", fmt::join(surfaces, ", ")),
                     "none");
  const Given* depth = cut.find("depth");
  if (depth != nullptr && name != "polyline")
    depth->refuse("no depth without a polyline");
  if (name == "plane") return plane_of(*chosen);
  if (name == "box") return box_of(*chosen);
  if (name == "cylinder") return cylinder_of(*chosen);
  if (depth == nullptr)
    throw InputError(chosen->place(), "", "a depth beside it", "none");
  return blade_of(*chosen, *depth);
}

std::string name_of_cut(const Written& cut, std::size_t number) {
  const Given* given = cut.find("name");
  if (given == nullptr)
    return number == 1 ? std::string("cut") : fmt::format("cut-{}", number);
  const std::string name = given->joined();
  constexpr std::string_view marks = ",=/\\\"'";  // of lists, links, texts
  const bool is_plain = std::ranges::none_of(name, [&](char c) {
    return marks.find(c) != marks.npos || static_cast<unsigned char>(c) <= ' ';
  });
  if (name.empty() || !is_plain)
    given->refuse("a name without spaces, commas, quotes, slashes and '='");
  return name;
}

WantedCut cut_of(const Written& cut, std::size_t number) {
  const Given* kind = cut.find("kind");
  if (kind == nullptr)
    throw InputError(cut.place, "",
                     fmt::format("a kind: {}", fmt::join(all_names<CutKind>(), " or ")),
                     "none");
  WantedCut wanted{.name = name_of_cut(cut, number),
                   .kind = named<CutKind>(*kind),
                   .where = {.surface = surface_of(cut)},
                   .place = cut.place};
  if (wanted.kind == CutKind::remove && !encloses(wanted.where.surface))
    throw InputError(cut.place, "", "a box or a cylinder, of which the inside is removed",
                     "a surface that encloses nothing");
  if (const Given* within = cut.find("within")) wanted.where.within = box_of(*within);
  return wanted;
}

std::string in_text(const Vector3& x) {
  return fmt::format("{},{},{}", x.x(), x.y(), x.z());
}

struct SurfaceText {
  std::string operator()(const Plane& plane) const {
    return fmt::format("plane={},{}", in_text(plane.normal), plane.offset);
  }
  std::string operator()(const Box& box) const {
    return fmt::format("box={},{}", in_text(box.low), in_text(box.high));
  }
  std::string operator()(const Cylinder& cylinder) const {
    return fmt::format("cylinder={},{},{}", in_text(cylinder.from), in_text(cylinder.to),
                       cylinder.radius);
  }
  std::string operator()(const Blade& blade) const {
    return fmt::format("polyline={},depth={}",
                       fmt::join(blade.points | std::views::transform(in_text), ","),
                       in_text(blade.depth));
  }
};

}  // namespace

const std::vector<CutKey>& cut_keys() {
  static const std::vector<CutKey> keys{
      {"name", name_text,
       "of the surfaces that it makes: NAME-below and NAME-above are the sides of a "
       "split, NAME is where cells are gone (default cut; of the second cut-2)"},
      {"kind", type_of<CutKind>(),
       "split: cells on the two sides of the surface no longer share faces; remove: "
       "cells inside it are gone"},
      {"plane", coordinates<4>,
       "a,b,c,d of the plane a x + b y + c z = d [m]; above it is where (a, b, c) "
       "points"},
      {"box", coordinates<6>,
       "x,y,z of its lower and of its upper corner [m]; above is outside"},
      {"cylinder", coordinates<7>,
       "x,y,z of both ends of its axis, and its radius [m]; above is outside"},
      {"polyline", points,
       "x,y,z of the points along which a blade goes [m]; above is on its left, where "
       "the depth points down"},
      {"depth", coordinates<3>, "x,y,z of how deep the blade of a polyline reaches [m]"},
      {"within", coordinates<6>,
       "x,y,z of the lower and the upper corner of a box, outside which nothing is cut "
       "[m]"}};
  return keys;
}

std::vector<WantedCut> cuts_of(const Given& given) {
  const std::vector<Written> written =
      given.has_tables() ? written_in_tables(given)
                         : written_in_text(given.place(), given.joined());
  std::vector<WantedCut> cuts;
  for (const Written& cut : written) {
    WantedCut wanted = cut_of(cut, cuts.size() + 1);
    if (std::ranges::count(cuts, wanted.name, &WantedCut::name) > 0)
      throw InputError(cut.place, "", "a name of its own for each cut",
                       fmt::format("a second one of '{}'", wanted.name));
    cuts.push_back(std::move(wanted));
  }
  return cuts;
}

std::string text_of(const std::vector<WantedCut>& cuts) {
  std::vector<std::string> texts;
  for (const WantedCut& cut : cuts) {
    texts.push_back(fmt::format("{},name={},{}", name_of(cut.kind), cut.name,
                                std::visit(SurfaceText{}, cut.where.surface)));
    if (cut.where.within)
      texts.back() += fmt::format(",within={},{}", in_text(cut.where.within->low),
                                  in_text(cut.where.within->high));
  }
  return fmt::format("{}", fmt::join(texts, ","));
}

nlohmann::json cuts_schema() {
  nlohmann::json properties;
  for (const CutKey& key : cut_keys()) {
    nlohmann::json& property = properties[std::string(key.name)] = schema_of(
        key.type, holds_numbers(key.type) ? Dimension::length : Dimension::none);
    property["description"] = key.description;
  }
  // Points may stand in lists of their own.
  properties["polyline"] = {{"type", "array"},
                            {"description", properties["polyline"]["description"]}};
  const nlohmann::json table{{"type", "object"},
                             {"properties", properties},
                             {"additionalProperties", false},
                             {"required", {"kind"}}},
      text{{"type", "string"}};
  const auto list_of = [](const nlohmann::json& items) {
    return nlohmann::json{{"type", "array"}, {"items", items}};
  };
  return {{"anyOf", {text, table, list_of(text), list_of(table)}}};
}

}  // namespace springcheck
