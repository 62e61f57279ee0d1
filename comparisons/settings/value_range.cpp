#include "comparisons/settings/value_range.hpp"

#include <fmt/format.h>

#include <cmath>
#include <regex>

#include "comparisons/settings/units.hpp"

namespace springcheck {
namespace {

/// A unit may begin with a digit: "3 1/s".
std::string joined(const std::string& number, const std::string& unit) {
  const bool is_apart = !unit.empty() && unit.front() >= '0' && unit.front() <= '9';
  return number + (is_apart ? " " : "") + unit;
}

}  // namespace

std::optional<WrittenNumber> written_number(const std::string& text) {
  const std::optional<Measurement> found = measurement(text);
  if (!found) return std::nullopt;
  const std::optional<double> value = value_of({found->number, ""}, Dimension::none);
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return WrittenNumber{*value, found->unit};
}

std::string text_of(const WrittenNumber& number) {
  return joined(fmt::format("{:.12g}", number.value), number.unit);
}

std::vector<std::string> values_between(const std::string& from, const std::string& to,
                                        int count) {
  const auto first = written_number(from), last = written_number(to);
  if (!first || !last || first->unit != last->unit) return {};
  const auto exactly = [](const WrittenNumber& end) {
    return joined(fmt::format("{}", end.value), end.unit);
  };
  std::vector<std::string> values{exactly(*first)};
  for (int i = 1; i < count - 1; ++i) {
    const double part = static_cast<double>(i) / (count - 1);
    values.push_back(
        text_of({(1 - part) * first->value + part * last->value, first->unit}));
  }
  values.push_back(exactly(*last));
  return values;
}

std::vector<std::string> values_of_range(const std::string& range) {
  static const std::regex form("([^:]+):([^:]+):(log:)?([0-9]{1,4})");
  std::smatch parts;
  if (!std::regex_match(range, parts, form)) return {};
  const auto first = written_number(parts[1]), last = written_number(parts[2]);
  const int count = std::stoi(parts[4]);
  if (!first || !last || first->unit != last->unit || !(first->value < last->value) ||
      count < 2 || count > 1000)
    return {};
  std::vector<std::string> values = values_between(parts[1], parts[2], count);
  if (!parts[3].matched) return values;
  if (!(first->value > 0)) return {};
  for (int i = 1; i < count - 1; ++i) {
    const double part = static_cast<double>(i) / (count - 1);
    const double value = first->value * std::pow(last->value / first->value, part);
    values[static_cast<std::size_t>(i)] = text_of({value, first->unit});
  }
  return values;
}

std::string short_text(const std::string& value) {
  const auto number = written_number(value);
  return number ? joined(fmt::format("{:.6g}", number->value), number->unit) : value;
}

}  // namespace springcheck
