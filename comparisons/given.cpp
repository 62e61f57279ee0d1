#include "comparisons/given.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "meshing/input_error.hpp"

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

std::optional<double> number(const Given::Scalar& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value))
    return static_cast<double>(*integer);
  if (const auto* real = std::get_if<double>(&value)) return *real;
  return std::nullopt;
}

std::string described(const Given::Scalar& value) {
  struct {
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(std::int64_t i) const { return std::to_string(i); }
    std::string operator()(double d) const { return fmt::format("{}", d); }
    std::string operator()(const std::string& s) const { return fmt::format("'{}'", s); }
  } describe;
  return std::visit(describe, value);
}

}  // namespace

Given Given::from_text(std::string place, std::string_view text) {
  std::vector<Scalar> values;
  while (true) {
    const std::size_t comma = text.find(',');
    values.push_back(scalar(text.substr(0, comma)));
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
  }
  return {std::move(place), std::move(values)};
}

void Given::refuse(const std::string& expected) const {
  std::string got;
  for (const Scalar& value : values_)
    got += fmt::format("{}{}", got.empty() ? "" : ", ", described(value));
  if (values_.size() != 1) got = fmt::format("[{}]", got);
  throw InputError(place_, "", expected, got);
}

const Given::Scalar& Given::single(const char* expected) const {
  if (values_.size() != 1) refuse(expected);
  return values_.front();
}

double Given::finite_number() const {
  const auto value = number(single("a finite number"));
  if (!value || !std::isfinite(*value)) refuse("a finite number");
  return *value;
}

double Given::positive_number() const {
  const auto value = number(single("a positive finite number"));
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

std::string Given::text() const {
  const auto* value = std::get_if<std::string>(&single("text"));
  if (value == nullptr) refuse("text");
  return *value;
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

std::array<double, 3> Given::three_numbers() const {
  std::array<double, 3> numbers{};
  if (values_.size() != 3) refuse("three finite numbers");
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = number(values_[i]);
    if (!value || !std::isfinite(*value)) refuse("three finite numbers");
    numbers[i] = *value;
  }
  return numbers;
}

std::array<std::int64_t, 3> Given::three_integers() const {
  std::array<std::int64_t, 3> integers{};
  if (values_.size() != 3) refuse("three integers");
  for (std::size_t i = 0; i < 3; ++i) {
    const auto* value = std::get_if<std::int64_t>(&values_[i]);
    if (value == nullptr) refuse("three integers");
    integers[i] = *value;
  }
  return integers;
}

double Given::deformation() const {
  constexpr const char* expected =
      "a finite number, or one with a unit such as '5%' or '45deg'";
  const Scalar& value = single(expected);
  if (const auto plain = number(value); plain && std::isfinite(*plain)) return *plain;
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) refuse(expected);
  const auto with_unit = [&](std::string_view unit) -> std::optional<double> {
    if (!text->ends_with(unit)) return std::nullopt;
    return parsed<double>(std::string_view(*text).substr(0, text->size() - unit.size()));
  };
  if (const auto percent = with_unit("%"); percent && std::isfinite(*percent))
    return *percent / 100;
  if (const auto degrees = with_unit("deg"); degrees && std::isfinite(*degrees))
    return *degrees * std::numbers::pi / 180;
  refuse(expected);
}

}  // namespace springcheck
