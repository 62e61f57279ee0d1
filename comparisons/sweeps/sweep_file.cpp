#include "comparisons/sweeps/sweep_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <ranges>
#include <tuple>

#include "comparisons/names/suggestion.hpp"
#include "comparisons/settings/run_settings.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/settings/toml_values.hpp"
#include "comparisons/settings/value_range.hpp"
#include "comparisons/shipped/shipped.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

/// Keys whose one value is a list of numbers.
bool is_list_valued(std::string_view key) {
  const Setting* setting = find_setting(key);
  return setting != nullptr && is_list_of_numbers(setting->access.type);
}

/// Keys whose one value is a list of tables.
bool is_list_of_tables(std::string_view key) {
  const Setting* setting = find_setting(key);
  return setting != nullptr && setting->access.type.kind == ValueType::Kind::table;
}

/// Keys of sweeps: scene, fields, cases and the options of `run`.
std::vector<std::string_view> sweep_keys() {
  std::vector<std::string_view> keys = option_keys();
  keys.insert(keys.begin(), {"scene", "fields", "cases"});
  return keys;
}

/// A number of a range as users write it, "5%".
std::string end_of_range(const toml::table& table, const char* end,
                         const std::string& file, const std::string& where) {
  const toml::node* node = table.get(end);
  if (node == nullptr) throw InputError(where, end, "a number", "none");
  const Given written = given(*node, file, end);
  const bool is_plain = node->is_integer() || node->is_floating_point();
  const auto number = written_number(written.joined());
  if (!number || !(is_plain || (node->is_string() && !number->unit.empty())))
    written.refuse("a finite number, plain or with a unit");
  return written.joined();
}

/// {from, to, count} of a setting that is one number.
std::vector<Given> range(const toml::table& table, const std::string& key,
                         const std::string& file, const std::string& where) {
  const Setting* setting = find_setting(key);
  if (setting == nullptr || !is_number(setting->access.type))
    throw InputError(where, "", "a value, or a list of values", "a table");
  for (const auto& [name, node] : table)
    if (name.str() != "from" && name.str() != "to" && name.str() != "count")
      refuse_name(place(file, name.source()), "key of a range", name.str(),
                  {"from", "to", "count"});
  const std::string from = end_of_range(table, "from", file, where),
                    to = end_of_range(table, "to", file, where);
  const auto count = table["count"].value_exact<std::int64_t>();
  if (!count || *count < 2 || *count > 1'000'000)
    throw InputError(where, "count", "an integer in [2, 1000000]",
                     count ? std::to_string(*count) : "none");
  std::vector<Given> values;
  for (const std::string& value : values_between(from, to, static_cast<int>(*count)))
    values.push_back(Given::from_text(where, value));
  if (values.empty())
    throw InputError(where, "", "from and to in one unit",
                     fmt::format("'{}' and '{}'", from, to));
  return values;
}

/// The value, or those of a range of a setting that is one number, "0.001:1:log:10".
std::vector<Given> one_or_range(const Given& value, const std::string& key,
                                const std::string& where) {
  const Setting* setting = find_setting(key);
  const bool is_range = setting != nullptr && is_number(setting->access.type) &&
                        value.is_text() && value.text().find(':') != std::string::npos;
  if (!is_range) return {value};
  std::vector<Given> values;
  for (const std::string& one : values_of_range(value.text()))
    values.push_back(Given::from_text(where, one));
  if (values.empty())
    value.refuse("a value, or a range FROM:TO:COUNT or FROM:TO:log:COUNT with FROM < TO");
  return values;
}

std::vector<Given> values_of(const std::string& key, const toml::node& node,
                             const std::string& file) {
  const std::string where = fmt::format("{}: {}", place(file, node.source()), key);
  if (const toml::table* table = node.as_table()) return range(*table, key, file, where);
  const toml::array* list = node.as_array();
  if (list == nullptr) return one_or_range(given(node, file, key), key, where);
  if (list->empty()) throw InputError(where, "", "at least one value", "an empty list");
  const bool one_value =
      (is_list_valued(key) &&
       std::ranges::none_of(*list, [](const toml::node& n) { return n.is_array(); })) ||
      (is_list_of_tables(key) &&
       std::ranges::all_of(*list, [](const toml::node& n) { return n.is_table(); }));
  if (one_value) return {given(node, file, key)};
  std::vector<Given> values;
  for (const toml::node& element : *list)
    for (Given& value : one_or_range(given(element, file, key), key, where))
      values.push_back(std::move(value));
  return values;
}

/// The choices of a table's keys, in the order of the file.
std::vector<Choices> choices_of(const toml::table& table, const std::string& file) {
  const std::vector<std::string_view> known = sweep_keys();
  std::vector<std::pair<toml::source_position, Choices>> found;
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    if (name == "fields" || name == "cases") continue;
    if (std::ranges::count(known, name) == 0)
      refuse_name(place(file, key.source()), "key", name, known);
    found.emplace_back(key.source().begin, Choices{name, values_of(name, node, file)});
  }
  std::ranges::stable_sort(found, [](const auto& a, const auto& b) {
    return std::tie(a.first.line, a.first.column) <
           std::tie(b.first.line, b.first.column);
  });
  std::vector<Choices> choices;
  for (auto& [position, choice] : found) choices.push_back(std::move(choice));
  return choices;
}

/// The common choices with a case's own put over them.
std::vector<Choices> combined(std::vector<Choices> common,
                              const std::vector<Choices>& own) {
  std::erase_if(common, [&](const Choices& choice) {
    return std::ranges::count(own, choice.key, &Choices::key) > 0;
  });
  common.insert(common.end(), own.begin(), own.end());
  return common;
}

std::vector<std::vector<Choices>> products(const toml::table& table,
                                           const std::string& file) {
  const std::vector<Choices> common = choices_of(table, file);
  const toml::node* node = table.get("cases");
  if (node == nullptr) return {common};
  const toml::array* cases = node->as_array();
  std::vector<std::vector<Choices>> all;
  if (cases != nullptr)
    for (const toml::node& one : *cases)
      if (const toml::table* own = one.as_table()) {
        if (own->contains("cases") || own->contains("fields"))
          throw InputError(place(file, own->source()), "cases", "options of `run`",
                           "cases or fields inside");
        all.push_back(combined(common, choices_of(*own, file)));
      }
  if (cases == nullptr || all.size() != cases->size() || all.empty())
    throw InputError(place(file, node->source()), "cases", "tables, [[cases]]", "others");
  return all;
}

std::size_t size_of(const std::vector<Choices>& product) {
  std::size_t size = 1;
  for (const Choices& choices : product) size *= choices.values.size();
  return size;
}

/// Combination `index` of the product; the last key varies fastest.
GivenSettings combination(const std::vector<Choices>& product, std::size_t index) {
  GivenSettings settings;
  for (const auto& choices : product | std::views::reverse) {
    const std::size_t count = choices.values.size();
    settings.push_back({choices.key, choices.values[index % count]});
    index /= count;
  }
  std::ranges::reverse(settings);
  return settings;
}

/// Throws InputError for more than `most` combinations.
void check_count(const Sweep& sweep, std::size_t most) {
  double count = 0;  // a size_t may run over
  for (const auto& product : sweep.products) {
    double size = 1;
    for (const Choices& choices : product)
      size *= static_cast<double>(choices.values.size());
    count += size;
  }
  if (count > static_cast<double>(most))
    throw InputError(sweep.file, "cases", fmt::format("at most {} without --yes", most),
                     fmt::format("{:.0f}", count));
}

/// Scenes of all products, each read once.
std::map<std::string, SceneFile> scenes_of(const Sweep& sweep) {
  std::map<std::string, SceneFile> scenes;
  for (const std::vector<Choices>& product : sweep.products) {
    const auto named = std::ranges::find(product, "scene", &Choices::key);
    if (named == product.end())
      throw InputError(sweep.file + ":1:1", "key 'scene'", "the name of a scene", "none");
    for (const Given& name : named->values)
      if (!scenes.contains(name.text()))
        scenes.emplace(name.text(), read_scene_named(name));
  }
  return scenes;
}

RunSettings run_of(const Sweep& sweep, const GivenSettings& settings) {
  const auto named = std::ranges::find(settings, "scene", &GivenSetting::key);
  const SceneFile& scene = sweep.scenes.at(named->value.text());
  GivenSettings all = scene.settings;
  for (const GivenSetting& setting : settings)
    if (setting.key != "scene") all.push_back(setting);
  return make_run_settings(scene.name, scene.file, all);
}

/// The combinations of what says how far bodies deform, all else at its first value.
std::vector<Choices> of_deformations(std::vector<Choices> product) {
  for (Choices& choices : product) {
    const bool deforms = choices.key == "scene" || choices.key == "deformation" ||
                         choices.key == "load-fractions";
    if (!deforms) choices.values.erase(choices.values.begin() + 1, choices.values.end());
  }
  return product;
}

Deformations deformations_of(const Sweep& sweep) {
  for (const std::vector<Choices>& all : sweep.products) {
    const std::vector<Choices> product = of_deformations(all);
    for (std::size_t i = 0; i < size_of(product); ++i) {
      try {
        if (!deforms_little(run_of(sweep, combination(product, i))))
          return Deformations::any;
      } catch (const InputError&) {
        // No test allows it; told when its turn comes.
      }
    }
  }
  return Deformations::small;
}

}  // namespace

bool takes_usual_reference(const Sweep& sweep) {
  return std::ranges::any_of(sweep.products, [&](const std::vector<Choices>& product) {
    const RunSettings run = run_of(sweep, combination(product, 0));
    return !run.reference &&
           std::ranges::any_of(run.methods, [](const MethodChoice& choice) {
             return choice.method.is_elastic;
           });
  });
}

Sweep read_sweep(const std::string& name_or_path, std::size_t most) {
  const TomlFile file = toml_file(name_or_path, a_sweep);
  const toml::table table = parse_toml(file.text, file.file);
  Sweep sweep{.name = file.name, .file = file.file, .with_fields = false};
  if (const toml::node* fields = table.get("fields"))
    sweep.with_fields = given(*fields, file.file, "fields").truth();
  sweep.products = products(table, file.file);
  check_count(sweep, most);
  sweep.scenes = scenes_of(sweep);
  sweep.usual_reference = usual_reference(deformations_of(sweep));
  return sweep;
}

std::size_t combination_count(const Sweep& sweep) {
  std::size_t count = 0;
  for (const auto& product : sweep.products) count += size_of(product);
  return count;
}

std::vector<Request> requests_of(const Sweep& sweep, std::size_t combination_index) {
  std::size_t index = combination_index;
  auto product = sweep.products.begin();
  while (index >= size_of(*product)) index -= size_of(*product++);
  return requests(run_of(sweep, combination(*product, index)), sweep.usual_reference);
}

std::vector<Request> all_requests(const Sweep& sweep) {
  std::vector<Request> all;
  for (std::size_t i = 0; i < combination_count(sweep); ++i)
    for (Request& request : requests_of(sweep, i)) all.push_back(std::move(request));
  return all;
}

}  // namespace springcheck
