#pragma once

#include "comparisons/cases/case.hpp"
#include "dynamics/marching/march.hpp"

namespace springcheck {

/// How the case's solver goes through time.
dynamics::Protocol protocol_of(const CaseSettings& settings);

/// What its static solver searches for, and how.
statics::Search search_of(const CaseSettings& settings);

/// What its linear systems take memory for, through time those of implicit steps.
LinearSystems::Kind linear_systems_of(const CaseSettings& settings);

}  // namespace springcheck
