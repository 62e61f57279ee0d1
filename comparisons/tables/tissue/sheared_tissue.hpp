#pragma once

#include <string_view>

#include "comparisons/tables/plans/planned_requests.hpp"

namespace springcheck {

/// mss-tissue in simple shear to a strain at a rate [1/s], 2 x 2 x 2 cells, 100 steps of
/// time: the scene tissue-shearing.
CaseSettings sheared_tissue(std::string_view organ, double rate, double strain);

}  // namespace springcheck
