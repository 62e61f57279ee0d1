#include "comparisons/gates/gate_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "comparisons/gates/gate_keys.hpp"
#include "comparisons/names/suggestion.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck::gates {
namespace {

void check_keys_of(const toml::table& table, const std::string& file,
                   const std::vector<std::string_view>& known) {
  for (const auto& [key, node] : table)
    if (std::ranges::count(known, key.str()) == 0)
      refuse_name(place(file, key.source()), "key", key.str(), known);
}

Condition condition_of(std::string_view column, const toml::node& node,
                       const std::string& file) {
  Condition condition{.column = std::string(column),
                      .place = fmt::format("{}: {}", place(file, node.source()), column),
                      .is_flat_list = false};
  const auto value_of = [&](const toml::node& one) {
    std::vector<Given::Scalar> numbers;
    if (const toml::array* list = one.as_array())
      for (const toml::node& number : *list) numbers.push_back(scalar(number, file));
    else
      numbers.push_back(scalar(one, file));
    for (const Given::Scalar& number : numbers)
      if (std::holds_alternative<Given::Table>(number) ||
          std::holds_alternative<Given::Unreadable>(number))
        throw InputError(condition.place, "",
                         "a number, text, truth value or list of them",
                         described(number));
    return numbers;
  };
  const toml::array* list = node.as_array();
  if (list != nullptr && list->empty())
    throw InputError(condition.place, "", "at least one value", "an empty list");
  const auto is_list = [](const toml::node& one) { return one.is_array(); };
  if (list != nullptr && std::ranges::all_of(*list, is_list)) {
    for (const toml::node& one : *list) condition.values.push_back(value_of(one));
  } else {
    condition.is_flat_list = list != nullptr;
    condition.values.push_back(value_of(node));
  }
  return condition;
}

/// The conditions in the table, under keys `other_than` this one.
Selection selection_of(const toml::table& table, const std::string& file,
                       std::string_view other_than = {}) {
  Selection selection;
  for (const auto& [key, node] : table)
    if (key.str() != other_than) selection.push_back(condition_of(key.str(), node, file));
  std::ranges::sort(selection, {}, [&](const Condition& condition) {
    const toml::source_position& at = table.get(condition.column)->source().begin;
    return std::pair(at.line, at.column);  // as written, for messages
  });
  return selection;
}

/// The key under which the other case's table may hold, beside settings, the name of its
/// measure.
constexpr std::string_view measure_key = "measure";

/// The table of settings under this key; none where it is missing.
const toml::table* settings_at(const toml::table& table, std::string_view key,
                               const std::string& file) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return nullptr;
  if (node->as_table() == nullptr)
    throw InputError(place(file, node->source()), std::string(key),
                     "a table of settings, such as { method = \"mss-cf\" }", "none");
  return node->as_table();
}

}  // namespace

void GateTable::check_keys() const {
  std::vector<std::string_view> known;
  for (const GateKey& key : gate_keys()) known.push_back(key.name);
  check_keys_of(table_, file_, known);
}

std::string GateTable::place() const {
  return springcheck::place(file_, table_.source());
}

toml::source_region GateTable::source(std::string_view key) const {
  return table_.get(key)->source();
}

Given GateTable::value(std::string_view key) const {
  return given(*table_.get(key), file_, key);
}

std::string GateTable::line(std::string_view key) const {
  if (!has(key)) refuse(key, "a text", "none");
  const std::string text = value(key).text();
  const bool has_controls = std::ranges::any_of(
      text, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; });
  if (text.empty() || has_controls)
    refuse(key, "a text of one line", text.empty() ? "''" : "control characters");
  return text;
}

std::string GateTable::text_or(std::string_view key, std::string otherwise) const {
  return has(key) ? line(key) : otherwise;
}

Selection GateTable::selection(std::string_view key) const {
  const toml::table* settings = settings_at(table_, key, file_);
  return settings == nullptr ? Selection{} : selection_of(*settings, file_);
}

OtherCase GateTable::other_case(std::string_view key, const Gate& own) const {
  OtherCase other{.where = own.where, .measure = own.measure};
  for (Condition& condition : other.where) condition.absent = Absent::passes;
  const toml::table& settings = *settings_at(table_, key, file_);
  if (settings.empty()) refuse(key, "settings of the other case", "none");
  if (const toml::node* measure = settings.get(measure_key))
    other.measure = given(*measure, file_, measure_key).text();
  other.where = narrowed(other.where, selection_of(settings, file_, measure_key));
  return other;
}

void GateTable::refuse(std::string_view key, const std::string& expected,
                       const std::string& got) const {
  const toml::node* node = table_.get(key);
  throw InputError(node != nullptr ? springcheck::place(file_, node->source()) : place(),
                   key.empty() ? "gate" : std::string(key), expected, got);
}

GateFileTable::GateFileTable(const toml::table& table, const std::string& file) {
  check_keys_of(table, file, {"where", "fixed", "gate"});
  const GateTable outer(table, file);
  common_ = outer.selection("where");
  for (Condition& condition : common_) condition.absent = Absent::passes;
  is_fixed_ = outer.has("fixed") && outer.value("fixed").truth();
  const toml::array* gates = table["gate"].as_array();
  if (gates == nullptr || gates->empty())
    throw InputError(file + ":1:1", "", "at least one [[gate]]", "none");
  for (const toml::node& gate : *gates) {
    if (gate.as_table() == nullptr)
      throw InputError(place(file, gate.source()), "gate", "tables: [[gate]]",
                       "something else");
    gates_.emplace_back(*gate.as_table(), file);
  }
}

}  // namespace springcheck::gates
