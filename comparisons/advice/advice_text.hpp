#pragma once

#include <string>

#include "comparisons/advice/advice.hpp"
#include "comparisons/advice/wish.hpp"
#include "comparisons/formats/table.hpp"

namespace springcheck {

/// What was asked for, in a line: scene, measures, tolerance and law.
std::string question(const Advice& advice, const Wish& wish);

/// The converged solution that the errors are measured against, in words.
std::string truth_text(const Advice& advice);

/// The points that the advice stands on, a row each with all errors that are known. JSON
/// tells besides which of them were asked for.
Table evidence_table(const Advice& advice, const Wish& wish);

/// What is against those points that were not chosen.
std::vector<std::string> notes_on_evidence(const Advice& advice);

/// Says that nothing meets the wish, and what that is due to.
std::string failure_text(const Advice& advice, const Wish& wish);

}  // namespace springcheck
