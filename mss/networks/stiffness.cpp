#include "mss/networks/stiffness.hpp"

#include <numbers>

namespace springcheck::mss {

LatticeStiffness shear_modulus_form(double shear_modulus, double cell_edge,
                                    double diagonal_ratio) {
  const double mu = shear_modulus, h = cell_edge, A = diagonal_ratio;
  const double k_c = 3 * mu * h / (3 * A + 4);
  const double k_f = A * k_c;
  return {.edge = k_f + 8. / 3 * k_c, .face_diagonal = k_f, .inner_diagonal = k_c};
}

LatticeStiffness young_modulus_form(double young_modulus, double cell_edge,
                                    double diagonal_ratio) {
  return shear_modulus_form(0.4 * young_modulus, cell_edge, diagonal_ratio);
}

LatticeStiffness baudet_stiffness(double young_modulus, double poisson_ratio,
                                  double cell_edge) {
  const double E = young_modulus, nu = poisson_ratio, h = cell_edge;
  const double k_ed = E * h * (4 * nu + 1) / (8 * (1 + nu));
  const double k_d = 3 * E * h / (8 * (1 + nu));
  return {.edge = 4 * k_ed, .face_diagonal = 0, .inner_diagonal = k_d};
}

double van_gelder_stiffness(double young_modulus, double volume, double length) {
  return young_modulus * volume / (length * length);
}

double lloyd_stiffness(double young_modulus, double length) {
  return 2 * std::numbers::sqrt2 / 25 * length * young_modulus;
}

double volume_correction_modulus(const Material& material) {
  const double E = material.young_modulus, nu = material.poisson_ratio;
  return E * (4 * nu - 1) / (2 * (1 + nu) * (1 - 2 * nu));
}

}  // namespace springcheck::mss
