#include "comparisons/commands/options/setting_options.hpp"

#include <CLI/CLI.hpp>

#include "comparisons/command_line/options.hpp"
#include "comparisons/formats/capitals.hpp"

namespace springcheck {

void SettingOptions::add_to(CLI::App& parser, bool (*is_taken)(const Setting&)) {
  parser.footer(
      "Values of a list have commas between them. Numbers are in SI units, or carry a "
      "unit: 10kPa, 5cm, 20ms, 5%, 45deg.");
  for (const Setting& setting : all_settings()) {
    if (!is_option(setting) || !is_taken(setting)) continue;
    const std::string name(setting.key), option = "--" + name;
    if (setting.access.type.kind == ValueType::Kind::truth)
      options_[name] = parser.add_flag(option)->description(help_of(setting));
    else
      options_[name] = parser.add_option(option, texts_[name], help_of(setting))
                           ->type_name(shown_type_of(setting));
    options_[name]->group(std::string(setting.group.heading));
  }
}

GivenSettings SettingOptions::given() const {
  GivenSettings settings;
  for (const auto& [name, option] : options_) {
    if (option->count() == 0) continue;
    const std::string place = "--" + name;
    const ValueType& type = find_setting(name)->access.type;
    if (!texts_.contains(name))
      settings.push_back({name, Given::from_text(place, "true")});
    else if ((type.kind == ValueType::Kind::text && type.names == nullptr) ||
             type.kind == ValueType::Kind::table)
      settings.push_back({name, Given(place, texts_.at(name))});  // commas and all
    else
      settings.push_back({name, Given::from_text(place, texts_.at(name))});
  }
  return settings;
}

bool is_any(const Setting&) {
  return true;
}

bool is_of_mesh(const Setting& setting) {
  return setting.group.name == "body" && setting.key != "fixed" && setting.key != "moved";
}

bool is_no_method(const Setting& setting) {
  return setting.key != "method" && setting.key != "element";
}

bool is_taken_by_charts(const Setting& setting) {
  return setting.in_charts == InCharts::taken;
}

std::string shown_type_of(const Setting& setting) {
  constexpr std::size_t short_enough = 16;
  const ValueType& type = setting.access.type;
  if (setting.key == "mesh") return "FILE";
  if (setting.key == "reference") return "METHOD";
  if (holds_numbers(type))
    return type.most > 1                           ? "NUMBERS"
           : type.kind == ValueType::Kind::integer ? "COUNT"
                                                   : "NUMBER";
  if (type.kind == ValueType::Kind::table) return in_capitals(setting.key);
  if (type.names == nullptr) return "NAME";
  const std::string names = alternatives(type.names());
  if (names.size() <= short_enough) return names;
  return in_capitals(setting.key);
}

}  // namespace springcheck
