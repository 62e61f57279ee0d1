#include "comparisons/command_line/help_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "comparisons/formats/wrapped_text.hpp"
#include "comparisons/system/terminal.hpp"

namespace springcheck {
namespace {

constexpr std::size_t margin = 2;

const Example to_try[] = {
    {"springcheck run compression", "one test by several methods"},
    {"springcheck table 5.1", "a table of the thesis beside ours"},
    {"springcheck reproduce --quick --out page", "five tests and their page"}};

std::string text_of_examples(std::span<const Example> examples, std::size_t width) {
  constexpr std::size_t indent = 6;
  std::string text;
  for (const auto& [words, what] : examples)
    text += fmt::format("{:{}}{}\n{:{}}{}\n", "", margin,
                        wrapped(words, width, indent + 4, margin), "", indent,
                        wrapped(what, width, indent, indent));
  return text;
}

std::string name_of(const OptionText& option) {
  std::string name = fmt::format("{}", fmt::join(option.names, ", "));
  if (!option.is_positional && !option.type.empty()) name += " " + option.type;
  return name;
}

std::string description_of(const OptionText& option) {
  const bool is_told = option.is_required && !option.is_positional;
  return option.description + (is_told ? " (needed)" : "");
}

}  // namespace

std::string help_text(const CommandText& command, std::size_t width) {
  const std::size_t column = std::min<std::size_t>(24, width / 3);
  std::string text = wrapped("Usage: " + usage_of(command), width, 4) + "\n\n" +
                     wrapped(command.summary + ". " + command.description, width) + "\n";
  text += "\nExamples:\n" + text_of_examples(command.examples, width);
  if (command.options.front().is_positional) text += "\n";
  for (const OptionText& option : command.options)
    if (option.is_positional)
      text += wrapped_entry(name_of(option), description_of(option), column, width);
  for (const std::string& group : groups_of(command)) {
    text += "\n" + group + ":\n";
    for (const OptionText& option : command.options)
      if (!option.is_positional && option.group == group)
        text += wrapped_entry(name_of(option), description_of(option), column, width);
  }
  if (!command.footer.empty()) text += "\n" + wrapped(command.footer, width) + "\n";
  return text;
}

std::string overview_text(std::span<const CommandText> commands, std::size_t width) {
  std::string text =
      wrapped(
          "springcheck compares mass-spring models of soft tissue with finite "
          "elements, on the same meshes.",
          width) +
      "\n\nThree commands to try:\n";
  for (const auto& [words, what] : to_try)
    text += wrapped_entry(words, what, width < 80 ? 6 : 45, width);
  text += "\nCommands:\n";
  for (const CommandText& command : commands)
    text += wrapped_entry(command.name, command.summary, 14, width);
  return text + "\n" +
         wrapped(
             "'springcheck help COMMAND' tells a command's options, with examples. "
             "--version tells the version, --verbose before a command logs every "
             "Newton iteration.",
             width) +
         "\n";
}

std::optional<std::size_t> width_of_lines() {
  constexpr std::size_t least = 40, most = 100;
  const auto columns = columns_of_output();
  return columns ? std::optional(std::clamp(*columns, least, most)) : std::nullopt;
}

}  // namespace springcheck
