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

/// 0.15, not 0.15000000000000002.
std::string text_of(const WrittenNumber& number);

/// So many numbers at equal distances, both ends among them; none unless both are numbers
/// of one unit. `count` is at least 2.
std::vector<std::string> values_between(const std::string& from, const std::string& to,
                                        int count);

}  // namespace springcheck
