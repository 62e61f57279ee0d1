#include "comparisons/studies/checked_number.hpp"

#include <algorithm>
#include <cmath>

namespace springcheck {

CheckedNumber checked_number(const ConvergedNumber& number,
                             const ConvergedNumber& check) {
  const bool is_of_check = check.error_bound < number.error_bound;
  const ConvergedNumber& better = is_of_check ? check : number;
  const ConvergedNumber& other = is_of_check ? number : check;
  const double disagreement = std::abs(better.value - other.value);
  const bool is_resolved = disagreement <= better.error_bound + other.error_bound;
  return {.value = better.value,
          .order = better.order,
          .error_bound = is_resolved ? std::max(better.error_bound, disagreement)
                                     : disagreement + other.error_bound,
          .is_of_check = is_of_check,
          .disagreement = disagreement,
          .is_resolved = is_resolved};
}

}  // namespace springcheck
