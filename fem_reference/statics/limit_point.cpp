#include "fem_reference/statics/limit_point.hpp"

#include <algorithm>
#include <iterator>

namespace springcheck::fem_reference {
namespace {

constexpr double farther = 1.9;  // twice but for rounding: steps of one size follow
constexpr double steeper = 2;
constexpr double faster = 1.01;

double slope(const Rate& from, const Rate& to) {
  return (to.displacement - from.displacement) / (to.load_fraction - from.load_fraction);
}

}  // namespace

bool limit_point_ahead(std::span<const Rate> rates, double failed) {
  if (rates.empty()) return false;
  // The nearest state that is twice as far from the failure as another.
  const auto farther_than = [&](auto place) {
    return std::find_if(place, rates.rend(), [&](const Rate& rate) {
      return failed - rate.load_fraction >= farther * (failed - place->load_fraction);
    });
  };
  const auto last = rates.rbegin();
  const auto middle = farther_than(last);
  if (middle == rates.rend()) return false;
  const auto first = farther_than(middle);
  if (first == rates.rend()) return false;
  return last->displacement > faster * middle->displacement &&
         slope(*middle, *last) > steeper * slope(*first, *middle);
}

}  // namespace springcheck::fem_reference
