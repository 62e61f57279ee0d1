#pragma once

#include <string>

#include "comparisons/advice/advice.hpp"
#include "comparisons/advice/wish.hpp"

namespace springcheck {

/// What was asked for, in a line: scene, measures, tolerance and law.
std::string question(const Advice& advice, const Wish& wish);

/// What the errors are of.
std::string truth_text(const Advice& advice);

/// The points that the advice stands on, a line each with all errors that are known, and
/// what is against the crossings.
std::string evidence_text(const Advice& advice, const Wish& wish);

/// Where nothing meets the wish: what that is due to.
std::string failure_text(const Advice& advice, const Wish& wish);

}  // namespace springcheck
