#pragma once

#include <optional>

#include "comparisons/studies/converged_number.hpp"

namespace springcheck {

/// What a number converges to, told by two discretisations a and b with their error
/// bounds, of which a's is the narrower:
///
///     resolved:    |a - b| <= bound a + bound b,   bound = max(bound a, |a - b|)
///     unresolved:  else,                           bound = |a - b| + bound b
///
/// about a, so that b, and where they contradict each other all that b allows, is within.
struct CheckedNumber {
  double value;
  std::optional<double> order;
  double error_bound;
  bool is_of_check = false;              // the value is b's
  std::optional<double> disagreement{};  // |a - b|; none where it is not checked

  // Whether the two agree; what is not checked contradicts nothing.
  bool is_resolved = true;
};

CheckedNumber checked_number(const ConvergedNumber& number, const ConvergedNumber& check);

}  // namespace springcheck
