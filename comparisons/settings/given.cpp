#include "comparisons/settings/given.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <ranges>

#include "comparisons/names/suggestion.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

template <class Number>
std::optional<Number> parsed(std::string_view text) {
  Number number{};
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || text.empty())
    return std::nullopt;
  return number;
}

Given::Scalar scalar(std::string_view text) {
  if (text == "true" || text == "false") return text == "true";
  if (const auto integer = parsed<std::int64_t>(text)) return *integer;
  if (const auto number = parsed<double>(text)) return *number;
  return std::string(text);
}

/// The text in quotes that TOML reads back.
std::string toml_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (static_cast<unsigned char>(c) < 0x20)
      quoted += fmt::format("\\u{:04x}", c);
    else
      quoted += c;
  }
  return quoted + '"';
}

}  // namespace

std::optional<double> number_in(const Given::Scalar& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value))
    return static_cast<double>(*integer);
  if (const auto* real = std::get_if<double>(&value)) return *real;
  return std::nullopt;
}

std::string described(const Given::Scalar& value) {
  struct {
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(std::int64_t i) const { return std::to_string(i); }
    std::string operator()(double d) const {
      const std::string text = fmt::format("{}", d);
      const bool looks_integral = text.find_first_of(".ein") == std::string::npos;
      return looks_integral ? text + ".0" : text;
    }
    std::string operator()(const std::string& s) const {
      return fmt::format("'{}'", clipped(s));
    }
    std::string operator()(const Given::Table&) const { return "a table"; }
    std::string operator()(const Given::Unreadable& u) const { return u.text; }
  } describe;
  return std::visit(describe, value);
}

Given Given::from_text(std::string place, std::string_view text) {
  std::vector<Scalar> values;
  while (true) {
    const std::size_t comma = text.find(',');
    values.push_back(scalar(text.substr(0, comma)));
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
  }
  if (values.size() == 1) return {std::move(place), std::move(values.front())};
  return {std::move(place), std::move(values)};
}

void Given::refuse(const std::string& expected) const {
  std::string got = fmt::format("{}", fmt::join((written_.empty() ? values_ : written_) |
                                                    std::views::transform(described),
                                                ", "));
  if (is_list_) got = fmt::format("[{}]", got);
  throw InputError(place_, "", expected, got);
}

const Given::Scalar& Given::single(const std::string& expected) const {
  if (is_list_) refuse(expected);
  return values_.front();
}

double Given::number(const std::string& expected) const {
  const auto value = number_in(single(expected));
  if (!value || !std::isfinite(*value)) refuse(expected);
  return *value;
}

double Given::finite_number() const {
  return number("a finite number");
}

double Given::positive_number() const {
  const auto value = number_in(single("a positive finite number"));
  if (!value || !std::isfinite(*value) || !(*value > 0))
    refuse("a positive finite number");
  return *value;
}

std::int64_t Given::integer() const {
  const auto* value = std::get_if<std::int64_t>(&single("an integer"));
  if (value == nullptr) refuse("an integer");
  return *value;
}

bool Given::truth() const {
  const auto* value = std::get_if<bool>(&single("true or false"));
  if (value == nullptr) refuse("true or false");
  return *value;
}

bool Given::is_text() const {
  return !is_list_ && std::holds_alternative<std::string>(values_.front());
}

std::string Given::text() const {
  const auto* value = std::get_if<std::string>(&single("text"));
  if (value == nullptr) refuse("text");
  return *value;
}

std::string Given::source() const {
  return place_.starts_with("--") ? "--" : place_.substr(0, place_.find(':'));
}

std::string Given::path() const {
  if (source() == "--") return text();
  return std::filesystem::path(source()).parent_path() / text();
}

std::vector<std::string> Given::texts() const {
  std::vector<std::string> all;
  for (const Scalar& value : values_) {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr || text->empty()) refuse("a list of names");
    all.push_back(*text);
  }
  if (all.empty()) refuse("at least one name");
  return all;
}

std::string Given::toml() const {
  const auto of_entry = [](const GivenSetting& entry) {
    return fmt::format("{} = {}", entry.key, entry.value.toml());
  };
  const auto of_value = [&](const Scalar& value) {
    if (const auto* table = std::get_if<Table>(&value))
      return fmt::format(
          "{{{}}}", fmt::join(*table->entries | std::views::transform(of_entry), ", "));
    const auto* text = std::get_if<std::string>(&value);
    return text == nullptr ? described(value) : toml_text(*text);
  };
  const auto all =
      fmt::format("{}", fmt::join(values_ | std::views::transform(of_value), ", "));
  return values_.size() == 1 && !is_list_ ? all : "[" + all + "]";
}

bool Given::has_tables() const {
  return std::ranges::any_of(
      values_, [](const Scalar& value) { return std::holds_alternative<Table>(value); });
}

std::vector<Given::Table> Given::tables(const std::string& expected) const {
  std::vector<Table> all;
  for (const Scalar& value : values_) {
    if (!std::holds_alternative<Table>(value)) refuse(expected);
    all.push_back(std::get<Table>(value));
  }
  return all;
}

std::string Given::joined() const {
  const auto of_value = [](const Scalar& value) {
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr ? *text : described(value);
  };
  return fmt::format("{}", fmt::join(values_ | std::views::transform(of_value), ","));
}

std::vector<double> Given::any_numbers(const std::string& expected) const {
  std::vector<double> all;
  for (const Scalar& value : values_) {
    const auto number = number_in(value);
    if (!number || !std::isfinite(*number)) refuse(expected);
    all.push_back(*number);
  }
  if (all.empty()) refuse("at least one finite number");
  return all;
}

std::array<std::int64_t, 3> Given::three_integers() const {
  std::array<std::int64_t, 3> integers{};
  if (values_.size() != 3) refuse("three integers such as 4,4,4");
  for (std::size_t i = 0; i < 3; ++i) {
    const auto* value = std::get_if<std::int64_t>(&values_[i]);
    if (value == nullptr) refuse("three integers such as 4,4,4");
    integers[i] = *value;
  }
  return integers;
}

Given Given::in_si_units(Dimension dimension) const {
  if (dimension == Dimension::none) return *this;
  Given converted = *this;
  converted.written_ = values_;
  for (Scalar& value : converted.values_) {
    const auto* text = std::get_if<std::string>(&value);
    const auto measured = text == nullptr ? std::nullopt : measurement(*text);
    if (!measured) continue;
    const std::optional<double> number = value_of(*measured, dimension);
    if (!number) refuse(numbers_in_units(dimension));
    value = *number;
  }
  return converted;
}

bool Given::had_units() const {
  return !written_.empty() && std::holds_alternative<std::string>(written_.front()) &&
         number_in(values_.front()).has_value();
}

double Given::in(Dimension dimension) const {
  return in_si_units(dimension).number(numbers_in_units(dimension));
}

void Given::refuse_name(std::string_view name,
                        const std::vector<std::string_view>& candidates) const {
  springcheck::refuse_name(place_, "value", name, candidates);
}

}  // namespace springcheck
