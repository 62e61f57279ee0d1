#include "mss/networks/strain_measure.hpp"

#include <boost/math/special_functions/log1p.hpp>

namespace springcheck::mss {

double hencky_energy(double x) {
  constexpr double a = hencky_constant, b = hencky_slope;
  const double y = a * x / (1 + b * x);
  return (x * x / ((1 + x) * (1 + b * x)) + boost::math::log1pmx(y) / (a * a)) / 4;
}

}  // namespace springcheck::mss
