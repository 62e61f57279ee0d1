#pragma once

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "comparisons/formats/table_format.hpp"
#include "comparisons/names/named.hpp"
#include "comparisons/names/suggestion.hpp"

namespace springcheck {

// Options that several commands have, each declared once. The type of an option, which
// help shows in place of its value, is words with | between them. In capitals stand what
// completion fills in: FILE, FOLDER, and lists of `springcheck list`, such as SCENE.

template <>
inline constexpr std::array value_names<TableFormat>{
    Named{TableFormat::markdown, "md"}, Named{TableFormat::csv, "csv"},
    Named{TableFormat::json, "json"}, Named{TableFormat::latex, "latex"}};

inline constexpr auto of_output = "output";  // the group of options that say what is kept

/// The names as alternatives: "md|csv|json|latex".
std::string alternatives(const std::vector<std::string_view>& names);

/// Adds an option that takes one of the names of an enumeration. Parsing throws
/// InputError for another.
template <class Enumeration, class Variable>
CLI::Option* add_choice(CLI::App& parser, const std::string& option, Variable& variable,
                        const std::string& help) {
  const std::string place = option.starts_with("--")
                                ? option
                                : "springcheck " + parser.get_name() + ": " + option;
  const auto read = [place, &variable](const std::string& text) {
    const auto* const found = find_value<Enumeration>(text);
    if (found == nullptr) refuse_name(place, "value", text, names_of<Enumeration>());
    variable = found->value;
  };
  return parser.add_option_function<std::string>(option, read, help)
      ->type_name(alternatives(names_of<Enumeration>()));
}

/// Refuses an empty name, for add_path.
std::string refusal_of_path(const std::string& text);

/// Adds an option for a file or folder; an empty name is refused.
template <class Path>
CLI::Option* add_path(CLI::App& parser, const std::string& option, Path& path,
                      const std::string& type, const std::string& help) {
  return parser.add_option(option, path, help)->check(refusal_of_path)->type_name(type);
}

CLI::Option* add_format(CLI::App& parser, std::optional<TableFormat>& format,
                        const std::string& otherwise);
/// Adds `--format`, and `--json`, short for `--format json`, to a command that otherwise
/// prints text for people.
void add_formats(CLI::App& parser, std::optional<TableFormat>& format);
CLI::Option* add_threads(CLI::App& parser, int& threads);

/// Adds an option for how many `what` run at the same time.
CLI::Option* add_jobs(CLI::App& parser, int& jobs, const std::string& what);

/// Adds an option for seconds above 0, or for 0 and more.
CLI::Option* add_seconds(CLI::App& parser, const std::string& option, double& seconds,
                         bool may_be_zero, const std::string& help);

/// Adds an option for a whole number in [least, most], into an integer or an optional
/// one.
template <class Count>
CLI::Option* add_count(CLI::App& parser, const std::string& option, Count& count,
                       int least, int most, const std::string& help) {
  return parser.add_option(option, count, help)
      ->check(CLI::Range(least, most).description(""))
      ->type_name("COUNT");
}

/// The cores of this machine: how many threads, or simulations at once, there are where
/// nothing else is asked for.
int all_cores();

}  // namespace springcheck
