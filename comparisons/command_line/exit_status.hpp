#pragma once

#include "comparisons/names/named.hpp"

namespace springcheck {

/// How the program ends; scripts depend on the numbers.
enum ExitStatus { done = 0, fell_short = 1, bad_input = 2, unexpected_status = 3 };

template <>
inline constexpr std::array value_names<ExitStatus>{
    Named{ExitStatus::done, "0", "done"},
    Named{ExitStatus::fell_short, "1",
          "a failure that was not foreseen; a gate that falls short; nothing meets what "
          "advise is asked for; a merge that found conflicts"},
    Named{ExitStatus::bad_input, "2",
          "bad input: nothing was computed; or a gate that has no case"},
    Named{ExitStatus::unexpected_status, "3",
          "a run of one method ended in a status that the scene's expect does not list; "
          "one of several did, or all, where --fail-on says so; or the program failed on "
          "a case, whose status is error"}};

}  // namespace springcheck
