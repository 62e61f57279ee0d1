#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/chart/chart.hpp"

namespace springcheck {

/// A recommended point and what it is told beside, places in a chart.
struct Advice {
  Chart chart;
  std::size_t truth;                     // of the scene's law
  std::optional<std::size_t> chosen;     // none: nothing meets the wish ...
  std::optional<std::size_t> nearest;    // ... and this comes closest
  std::vector<std::size_t> equals;       // sound, as quick as far as times can tell, and
                                         // of more memory
  std::optional<std::size_t> cheaper;    // most accurate of the cheaper ones
  std::optional<std::size_t> not_shown;  // cheapest of the sound cheaper ones, of which
                                         // the truth's own error bound decides
  std::optional<std::size_t> dearer;     // cheapest of the more accurate ones
  // What meets the wish by errors that cancel, and in words what is against it:
  std::vector<std::pair<std::size_t, std::string>> crossings;
  bool is_path_known = true;          // whether the chosen one's was followed
  std::vector<std::string> left_out;  // in words: what the chosen one does without
  std::vector<std::string> cautions;
};

}  // namespace springcheck
