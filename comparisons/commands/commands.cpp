#include "comparisons/commands/commands.hpp"

#include <nlohmann/json.hpp>

#include "comparisons/formats/capitals.hpp"
#include "comparisons/names/suggestion.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/vocabulary/vocabulary.hpp"

namespace springcheck {
namespace {

/// METHOD: the names that the setting `method` takes, or those of the list `methods`.
std::vector<std::string> names_behind(const std::string& capitals,
                                      const nlohmann::ordered_json& lists) {
  const std::string name = in_small_letters(capitals);
  const Setting* const setting = find_setting(name);
  if (setting != nullptr && setting->access.type.names != nullptr) {
    const auto names = setting->access.type.names();
    return {names.begin(), names.end()};
  }
  const auto list = lists.find(name + (name.ends_with("s") ? "es" : "s"));
  std::vector<std::string> names;
  if (list != lists.end())
    for (const auto& entry : list->items()) names.push_back(entry.key());
  return names;
}

}  // namespace

Declarations declarations() {
  Declarations all{.commands = {}, .lists = list_json()};
  for (const auto& make : every_command)
    all.commands.push_back(text_of(make(), [&](const std::string& capitals) {
      return names_behind(capitals, all.lists);
    }));
  return all;
}

Command command_named(std::string_view name) {
  std::vector<std::string_view> names;
  for (const auto& make : every_command) {
    Command command = make();
    if (command.name == name) return command;
    names.push_back(command.name);
  }
  refuse_name("springcheck", "command", name, names);
}

}  // namespace springcheck
