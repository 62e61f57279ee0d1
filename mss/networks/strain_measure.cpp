#include "mss/networks/strain_measure.hpp"

#include "meshing/basics/logarithm.hpp"

namespace springcheck::mss {

double hencky_energy(double x) {
  constexpr double a = hencky_constant, b = hencky_slope;
  const double y = a * x / (1 + b * x);
  return (x * x / ((1 + x) * (1 + b * x)) + log1p_minus(y) / (a * a)) / 4;
}

}  // namespace springcheck::mss
