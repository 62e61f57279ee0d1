#include "comparisons/command_line/manual_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/command_line/exit_status.hpp"
#include "comparisons/formats/capitals.hpp"

namespace springcheck {
namespace {

/// Text as roff prints it: hyphens are those that a terminal's search finds, and no line
/// begins with a dot or an apostrophe, which would make it a macro.
std::string escaped(std::string_view text) {
  std::string roff;
  for (const char c : text) {
    if (c == '\\')
      roff += "\\e";
    else if (c == '"')  // it would hold an argument of a macro together
      roff += "\\(dq";
    else if (c == '-')
      roff += "\\-";
    else if ((c == '.' || c == '\'') && roff.empty())
      roff += std::string("\\&") + c;
    else
      roff += c;
  }
  return roff;
}

std::string head(const std::string& name, std::string_view summary) {
  return fmt::format(
      ".TH {} 1 \"\" \"springcheck {}\" \"User Commands\"\n"
      ".SH NAME\n{} \\- {}\n",
      escaped(in_capitals(name)), build_info::version, escaped(name), escaped(summary));
}

/// An entry of the page, with its name in bold before the text.
std::string entry(std::string_view name, std::string_view text) {
  return fmt::format(".TP\n.B {}\n{}\n", escaped(name), escaped(text));
}

std::string text_of_exit_statuses() {
  std::string text = ".SH EXIT STATUS\n";
  for (const auto& status : value_names<ExitStatus>)
    text += entry(status.name, status.description);
  return text;
}

std::string name_of_page(std::string_view command) {
  return fmt::format("springcheck-{}", command);
}

}  // namespace

std::string manual_page(const CommandText& command) {
  std::string page = head(name_of_page(command.name), command.summary);
  page += fmt::format(".SH SYNOPSIS\n.B {}\n", escaped(usage_of(command)));
  page += fmt::format(".SH DESCRIPTION\n{}\n",
                      escaped(command.summary + ". " + command.description));
  const auto add = [&](const OptionText& option) {
    std::string name = fmt::format("{}", fmt::join(option.names, ", "));
    if (!option.is_positional && !option.type.empty()) name += " " + option.type;
    const bool is_told = option.is_required && !option.is_positional;
    page += entry(name, option.description + (is_told ? " (needed)" : ""));
  };
  for (const OptionText& option : command.options)
    if (option.is_positional) add(option);
  page += ".SH OPTIONS\n";
  std::vector<std::string> groups = groups_of(command);
  std::ranges::rotate(groups, groups.end() - 1);  // those without a group need no heading
  for (const std::string& group : groups) {
    if (group != groups.front()) page += fmt::format(".SS {}\n", escaped(group));
    for (const OptionText& option : command.options)
      if (!option.is_positional && option.group == group) add(option);
  }
  if (!command.footer.empty()) page += ".PP\n" + escaped(command.footer) + "\n";
  page += ".SH EXAMPLES\n";
  for (const auto& [words, what] : command.examples) page += entry(words, what);
  return page + text_of_exit_statuses() + ".SH SEE ALSO\n.BR springcheck (1)\n";
}

std::string manual_page(std::span<const CommandText> commands) {
  std::string page = head(
      "springcheck", "compares mass-spring models of soft tissue with finite elements");
  page +=
      ".SH SYNOPSIS\n.B springcheck\n[\\-\\-verbose] COMMAND [OPTIONS]\n.SH COMMANDS\n";
  for (const CommandText& command : commands)
    page += entry(command.name, command.summary);
  page += text_of_exit_statuses() + ".SH SEE ALSO\n";
  for (const CommandText& command : commands)
    page += fmt::format(".BR {} (1){}\n", escaped(name_of_page(command.name)),
                        &command == &commands.back() ? "" : ",");
  return page;
}

}  // namespace springcheck
