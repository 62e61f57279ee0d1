#include "comparisons/studies/checked_number.hpp"

#include <algorithm>
#include <cmath>

namespace springcheck {

CheckedNumber checked_number(const ConvergedNumber& number,
                             const ConvergedNumber& check) {
  const bool is_of_check = check.bar < number.bar;
  const ConvergedNumber& better = is_of_check ? check : number;
  const ConvergedNumber& other = is_of_check ? number : check;
  const double disagreement = std::abs(better.value - other.value);
  const bool is_resolved = disagreement <= better.bar + other.bar;
  return {
      .value = better.value,
      .order = better.order,
      .bar = is_resolved ? std::max(better.bar, disagreement) : disagreement + other.bar,
      .is_of_check = is_of_check,
      .disagreement = disagreement,
      .is_resolved = is_resolved};
}

}  // namespace springcheck
