#pragma once

#include "comparisons/cases/case.hpp"
#include "dynamics/marching/march.hpp"

namespace springcheck {

/// How the case's solver goes through time.
dynamics::Protocol protocol_of(const CaseSettings& settings);

}  // namespace springcheck
