#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <optional>

#include "comparisons/command_line/help_text.hpp"
#include "comparisons/command_line/options.hpp"
#include "comparisons/front/front_commands.hpp"
#include "comparisons/front/list_text.hpp"
#include "comparisons/names/suggestion.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string what{};
  std::optional<TableFormat> format{};
};

std::vector<std::string_view> names_of(const Json& lists) {
  std::vector<std::string_view> names;
  for (const auto& list : lists.items()) names.push_back(list.key());
  return names;
}

ExitStatus list(const Options& options, const Json& lists) {
  if (!options.what.empty() && !lists.contains(options.what))
    refuse_name("springcheck list", "list", options.what, names_of(lists));
  const Json asked =
      options.what.empty() ? lists : Json{{options.what, lists[options.what]}};
  if (options.format == TableFormat::json)
    fmt::print("{}\n", asked.dump(2));
  else if (options.format)
    fmt::print("{}", lists_as_table(asked, *options.format));
  else
    fmt::print("{}", list_text(asked, width_of_lines()));
  return ExitStatus::done;
}

Action declare_list(CLI::App& parser, const Json& lists) {
  const auto options = std::make_shared<Options>();
  const auto names = names_of(lists);
  parser
      .add_option("what", options->what,
                  fmt::format("one of {} (default: all)", fmt::join(names, ", ")))
      ->type_name(alternatives(names));
  add_formats(parser, options->format);
  return [options, &lists] { return list(*options, lists); };
}

}  // namespace

Command list_command(const Declarations& all) {
  return {
      .name = "list",
      .summary = "List methods, scenes, settings, measures and what else there is",
      .description = "",
      .examples = {{"springcheck list methods", "every method, and what it covers"},
                   {"springcheck list scenes", "the shipped scenes"},
                   {"springcheck list settings --json",
                    "every setting with group, unit, names and default"}},
      .declare = [&all](CLI::App& parser) { return declare_list(parser, all.lists); }};
}

}  // namespace springcheck
