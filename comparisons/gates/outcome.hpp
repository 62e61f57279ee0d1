#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/gates/gate.hpp"
#include "comparisons/names/named.hpp"

namespace springcheck::gates {

enum class Judgement { pass, falls_short, no_case };

}  // namespace springcheck::gates

namespace springcheck {
template <>
inline constexpr std::array value_names<gates::Judgement>{
    Named{gates::Judgement::pass, "pass"},
    Named{gates::Judgement::falls_short, "falls short"},
    Named{gates::Judgement::no_case, "no case"}};
}  // namespace springcheck

namespace springcheck::gates {

/// What came of a gate.
struct Outcome {
  Judgement verdict = Judgement::pass;
  bool is_status_expected = true;   // of all its cases
  std::vector<std::string> keys{};  // of its cases, along a sweep in its order
  std::optional<double> got{};      // none along a sweep, and where it is null
  std::vector<double> values{};     // along a sweep
  Range band{};
  std::string got_text = "-", band_text = "-";
  // Distance to the nearest edge of the band over its half width: 1 at the middle, below
  // 0 outside. Of bands open to one side, over the edge's magnitude; of a monotonic
  // sweep, its smallest step over the whole change.
  std::optional<double> margin{};
  std::string explanation{};  // unless it passes
};

/// What `margin` is, in words.
inline constexpr std::string_view margin_definition =
    "distance to the nearest edge of the band over its half width (1 in the middle, "
    "below "
    "0 outside); of a band open to one side, over its edge; of a monotonic sweep, the "
    "smallest step over the whole change";

/// One more reason why it falls short.
void fall_short(Outcome& outcome, const std::string& why);

/// Fills in value, band and margin; a value outside falls short. What is null has fallen
/// short before.
void compare(Outcome& outcome, const Range& band, const std::optional<double>& got);
void compare_about(Outcome& outcome, double middle, const Width& width,
                   const std::optional<double>& got);

/// ">= 0.5", "0.5 .. 2"
std::string text_of(const Range& band);

}  // namespace springcheck::gates
