#include "comparisons/gates/gate.hpp"

#include <algorithm>
#include <cmath>

namespace springcheck::gates {

double half_width(const Width& width, double about) {
  return std::max(width.absolute, width.relative * std::abs(about));
}

}  // namespace springcheck::gates
