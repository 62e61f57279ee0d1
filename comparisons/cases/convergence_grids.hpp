#pragma once

#include <array>

#include "comparisons/cases/case.hpp"

namespace springcheck {

/// One case on three grids, from coarse to fine.
using ThreeCases = std::array<CaseSettings, 3>;

/// The case on its own cells and on two and four times as many along each axis.
ThreeCases convergence_grids(const CaseSettings& settings);

}  // namespace springcheck
