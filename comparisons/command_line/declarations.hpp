#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/command_line/command_text.hpp"

namespace springcheck {

/// What a program can tell without computing.
struct Declarations {
  std::vector<CommandText> commands;  // in the order in which help tells them
  nlohmann::ordered_json lists;  // {list: {name: ...}}, see `springcheck list --json`
};

std::string text_of(const Declarations& declarations);

/// The declarations in a text that text_of() made.
Declarations declarations_from(std::string_view text);

std::vector<std::string_view> command_names(const Declarations& declarations);

/// The command of that name. Throws InputError for another name, with the nearest.
const CommandText& command_named(std::string_view name, const Declarations& declarations);

}  // namespace springcheck
