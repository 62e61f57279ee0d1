#pragma once

#include <optional>
#include <string>
#include <vector>

namespace springcheck {

/// A finite number as users write it, and the unit behind it, "5" and "%".
struct WrittenNumber {
  double value;
  std::string unit;
};
std::optional<WrittenNumber> written_number(const std::string& text);

/// The number as users write it: 0.15, not 0.15000000000000002.
std::string text_of(const WrittenNumber& number);

/// `count` numbers at equal distances, both ends among them; none unless both are numbers
/// of one unit. `count` is at least 2.
std::vector<std::string> values_between(const std::string& from, const std::string& to,
                                        int count);

/// The values of FROM:TO:COUNT, at equal distances, or of FROM:TO:log:COUNT, by equal
/// factors; FROM < TO in one unit, COUNT from 2 to 1000. None where that is not what is
/// written, or a logarithm has none.
std::vector<std::string> values_of_range(const std::string& range);

/// The value with at most six digits: 43.3333%.
std::string short_text(const std::string& value);

}  // namespace springcheck
