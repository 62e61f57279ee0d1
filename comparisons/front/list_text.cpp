#include "comparisons/front/list_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "comparisons/formats/latex_table.hpp"
#include "comparisons/formats/text_table.hpp"
#include "comparisons/formats/wrapped_text.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

/// The heading of an entry: "W wrinkling", "force [N]".
std::string heading_of(const std::string& name, const Json& entry) {
  if (entry.contains("letter"))
    return fmt::format("{} {}", entry["letter"].get<std::string>(), name);
  if (entry.contains("unit") && entry["unit"] != "")
    return fmt::format("{} [{}]", name, entry["unit"].get<std::string>());
  return name;
}

/// A value as text: "yes", "4", "a b", or the text itself; nothing for an object.
std::string as_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_array()) {
    std::vector<std::string> texts;
    for (const Json& one : value) texts.push_back(as_text(one));
    return fmt::format("{}", fmt::join(texts, " "));
  }
  return value.is_number() ? value.dump() : "";
}

std::string description_of(const Json& entry) {
  return as_text(entry.is_string() ? entry : entry["description"]);
}

/// The tests of measures, where those are not all that there are.
std::string tests_of(const Json& entry, std::size_t of_all) {
  if (!entry.contains("tests") || entry["tests"].size() == of_all) return "";
  return fmt::format("{}",
                     fmt::join(entry["tests"].get<std::vector<std::string>>(), ", "));
}

std::string text_of_entries(const Json& entries, std::optional<std::size_t> width) {
  constexpr std::size_t least = 18, margin = 2;
  const std::size_t most = width.value_or(std::numeric_limits<std::size_t>::max());
  std::size_t column = least, most_tests = 0;
  for (const auto& [name, entry] : entries.items()) {
    column = std::max(column, characters_in(heading_of(name, entry)) + 2 * margin);
    if (entry.contains("tests")) most_tests = std::max(most_tests, entry["tests"].size());
  }
  column = std::min(column, most / 3);
  std::string text;
  for (const auto& [name, entry] : entries.items()) {
    text += wrapped_entry(heading_of(name, entry), description_of(entry), column, most);
    const auto add = [&](const std::string& further) {
      text += std::string(column, ' ') + wrapped(further, most, column, column) + "\n";
    };
    if (entry.contains("covers")) add("covers " + as_text(entry["covers"]));
    if (const std::string tests = tests_of(entry, most_tests); !tests.empty())
      add("in " + tests);
  }
  return text;
}

/// The columns of all entries, in the order in which they come first.
std::vector<std::string> columns_of(const Json& lists) {
  std::vector<std::string> columns{"description"};
  for (const Json& entries : lists)
    for (const Json& entry : entries) {
      if (!entry.is_object()) continue;
      for (const auto& value : entry.items())
        if (!value.value().is_object() && std::ranges::count(columns, value.key()) == 0)
          columns.push_back(value.key());
    }
  return columns;
}

TextLines lines_of(const Json& lists) {
  const std::vector<std::string> columns = columns_of(lists);
  TextLines lines{{"list", "name"}};
  lines[0].insert(lines[0].end(), columns.begin(), columns.end());
  for (const auto& [list, entries] : lists.items())
    for (const auto& [name, entry] : entries.items()) {
      std::vector<std::string> line{list, name, description_of(entry)};
      for (std::size_t i = 1; i < columns.size(); ++i)
        line.push_back(entry.is_object() && entry.contains(columns[i])
                           ? as_text(entry[columns[i]])
                           : "");
      lines.push_back(std::move(line));
    }
  return lines;
}

/// The title of lists: "methods" for one list, for several what they are together.
std::string title_of(const Json& lists) {
  return lists.size() == 1 ? lists.begin().key() : "What springcheck lists";
}

}  // namespace

std::string list_text(const Json& lists, std::optional<std::size_t> width) {
  std::string text;
  for (const auto& [heading, entries] : lists.items())
    text += heading + "\n" + text_of_entries(entries, width);
  return text;
}

std::string lists_as_table(const Json& lists, TableFormat format) {
  const TextLines lines = lines_of(lists);
  switch (format) {
    case TableFormat::csv:
      return csv_text(lines);
    case TableFormat::markdown:
      return markdown_text(without_empty_columns(lines),
                           {.title = title_of(lists), .notes = {}, .footnotes = {}});
    case TableFormat::latex:
      return latex_text(without_empty_columns(lines),
                        {.title = title_of(lists), .notes = {}, .footnotes = {}});
    case TableFormat::json:
      break;
  }
  throw std::logic_error("lists are JSON already");
}

}  // namespace springcheck
