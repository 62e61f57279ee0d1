#pragma once

#include <CLI/App.hpp>
#include <map>
#include <string>
#include <vector>

#include "comparisons/settings/setting.hpp"

namespace springcheck {

/// The settings among a command's options.
class SettingOptions {
 public:
  SettingOptions() = default;
  SettingOptions(const SettingOptions&) = delete;  // the parser writes into the texts
  SettingOptions& operator=(const SettingOptions&) = delete;

  /// Adds the settings that the command takes, in their groups.
  void add_to(CLI::App& parser, bool (*is_taken)(const Setting&));

  /// The settings that were given, as text.
  [[nodiscard]] GivenSettings given() const;

 private:
  std::map<std::string, CLI::Option*> options_;
  std::map<std::string, std::string> texts_;
};

// Which settings commands take:
bool is_any(const Setting& setting);
bool is_of_mesh(const Setting& setting);
bool is_no_method(const Setting& setting);
bool is_taken_by_charts(const Setting& setting);

/// What stands in the place of a setting's value: "on|off", its key in capitals where
/// there are more names, or NUMBER.
std::string shown_type_of(const Setting& setting);

}  // namespace springcheck
