#include "tissue/rheometer.hpp"

#include <cmath>
#include <numbers>

#include "tissue/checks.hpp"

namespace springcheck::tissue {

using std::numbers::pi;

double disc_torque(const BipowerLaw& law, double rim_strain, double rim_rate,
                   double radius) {
  check_positive("radius of the disc [m]", radius);
  const auto [linear, hardening] = constant_rate_stress(law, rim_strain, rim_rate);
  return 2 * pi * std::pow(radius, 3) *
         (linear / 4 + hardening / (law.hardening_index + 4));
}

double apparent_stress(double torque, double radius) {
  check_positive("radius of the disc [m]", radius);
  return 2 * torque / (pi * std::pow(radius, 3));
}

}  // namespace springcheck::tissue
