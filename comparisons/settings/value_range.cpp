#include "comparisons/settings/value_range.hpp"

#include <fmt/format.h>

#include <cmath>

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

}  // namespace springcheck
