#pragma once

#include <map>
#include <span>
#include <string>

#include "comparisons/cases/status.hpp"
#include "comparisons/formats/table.hpp"

namespace springcheck {

/// A summary in markdown: how all cases of the result file ended, how far mss-cf and
/// fem-hencky are from the printed figures, and which rows are not ok. `statuses` are
/// those of the cases, by their keys; `seconds` is the time that it took.
std::string summary(std::span<const Table> tables,
                    const std::map<std::string, Status>& statuses, double seconds);

}  // namespace springcheck
