#pragma once

#include <string>

#include "comparisons/advice/advice.hpp"
#include "comparisons/advice/wish.hpp"
#include "comparisons/formats/table.hpp"

namespace springcheck {

/// What was asked for, in a line: scene, measures, tolerance and law.
std::string question(const Advice& advice, const Wish& wish);

/// What the errors are of.
std::string truth_text(const Advice& advice);

/// The points that the advice stands on, a row each with all errors that are known. JSON
/// tells besides which of them were asked for.
Table evidence_table(const Advice& advice, const Wish& wish);

/// What is against those points that were not chosen.
std::vector<std::string> notes_on_evidence(const Advice& advice);

/// Where nothing meets the wish: what that is due to.
std::string failure_text(const Advice& advice, const Wish& wish);

}  // namespace springcheck
