#include "meshing/basics/logarithm.hpp"

#include <boost/math/special_functions/log1p.hpp>
#include <limits>

namespace springcheck {

double log1p_minus(double x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (x <= -1 || x == infinity) return -infinity;  // Boost's throws at -1
  return boost::math::log1pmx(x);
}

}  // namespace springcheck
