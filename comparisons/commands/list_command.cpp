#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "comparisons/cases/test.hpp"
#include "comparisons/command_line/options.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/settings/suggestion.hpp"
#include "comparisons/vocabulary/vocabulary.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

/// "W wrinkling", "force [N]".
std::string heading_of(const std::string& name, const Json& entry) {
  if (entry.contains("letter"))
    return fmt::format("{} {}", entry["letter"].get<std::string>(), name);
  if (entry.contains("unit") && entry["unit"] != "")
    return fmt::format("{} [{}]", name, entry["unit"].get<std::string>());
  return name;
}

void print_entries(const Json& entries) {
  std::size_t width = 15;
  for (const auto& [name, entry] : entries.items())
    width = std::max(width, heading_of(name, entry).size());
  for (const auto& [name, entry] : entries.items()) {
    const Json& text = entry.is_string() ? entry : entry["description"];
    fmt::print("  {:<{}} {}\n", heading_of(name, entry), width, text.get<std::string>());
    if (entry.contains("covers"))
      fmt::print("  {:<{}} covers {}\n", "", width, entry["covers"].get<std::string>());
    if (entry.contains("tests") && entry["tests"].size() < value_names<Test>.size())
      fmt::print("  {:<{}} in {}\n", "", width,
                 fmt::join(entry["tests"].get<std::vector<std::string>>(), ", "));
  }
}

ExitStatus list(const std::string& what, Output output) {
  const Json all = list_json(what);
  if (all.empty()) refuse_name("springcheck list", "list", what, list_names());
  if (output == Output::json) {
    fmt::print("{}\n", all.dump(2));
    return ExitStatus::done;
  }
  for (const auto& [heading, entries] : all.items()) {
    fmt::print("{}\n", heading);
    print_entries(entries);
  }
  return ExitStatus::done;
}

Action declare_list(CLI::App& parser) {
  struct Options {
    std::string what{};
    Output output = Output::text;
  };
  const auto options = std::make_shared<Options>();
  parser
      .add_option("what", options->what,
                  fmt::format("one of {} (default: all)", fmt::join(list_names(), ", ")))
      ->type_name(alternatives(list_names()));
  add_json(parser, options->output);
  return [options] { return list(options->what, options->output); };
}

}  // namespace

Command list_command() {
  return {.name = "list",
          .summary = "List methods, scenes, settings, measures and what else there is",
          .description = "",
          .examples = {{"springcheck list methods", "every method, and what it covers"},
                       {"springcheck list scenes", "the shipped scenes"},
                       {"springcheck list settings --json",
                        "every setting with group, unit, names and default"}},
          .simulates = false,
          .declare = declare_list};
}

}  // namespace springcheck
