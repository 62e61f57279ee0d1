#pragma once

#include "comparisons/formats/table.hpp"
#include "comparisons/stability/atlas.hpp"

namespace springcheck {

/// A row for each point: method, values, how it fails, status and what the detectors saw.
Table points_table(const Atlas& atlas, const AtlasPlan& plan);

/// A row for each limit.
Table limits_table(const Atlas& atlas, const AtlasPlan& plan);

/// The maps for a terminal, one of letters for each method, the first axis upwards, the
/// second to the right; and what the letters mean.
std::string maps_text(const Atlas& atlas, const AtlasPlan& plan);

}  // namespace springcheck
