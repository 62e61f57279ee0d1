#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "comparisons/gates/gate.hpp"
#include "comparisons/gates/outcome.hpp"

namespace springcheck::gates {

/// A stored value and what replaces it.
struct Blessed {
  std::size_t gate;  // its index
  double old_value, new_value;
};

/// What --bless replaces: stored values whose gate falls short by the value alone, its
/// status being as expected, and that are not fixed. A value within its band stays, so
/// that drift does not pass step by step; null and 0 in a relative band are no values to
/// store.
std::vector<Blessed> to_bless(const std::vector<Gate>& gates,
                              const std::vector<Outcome>& outcomes);

/// The text of the gate file with these values replaced and every other byte as it was.
/// `file` is for messages. Throws std::runtime_error where the text would not be read
/// back as the same gates with the new values.
std::string with_blessed(std::string_view text, const std::string& file,
                         const std::vector<Gate>& gates,
                         const std::vector<Blessed>& values);

}  // namespace springcheck::gates
