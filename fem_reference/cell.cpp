#include "fem_reference/cell.hpp"

#include <algorithm>
#include <limits>

namespace springcheck::fem_reference {
namespace {

Matrix3 displacement_gradient(const CellVectors& u, const GaussPoint& point) {
  return u * point.gradients.transpose();
}

double mean_trace(Law law, const Cell& cell, const CellVectors& u) {
  double integral = 0;
  for (const GaussPoint& point : cell.points)
    integral += point.weight * strain(law, displacement_gradient(u, point)).trace();
  return integral / cell.volume;
}

EnergyDensity with_mean_stress(EnergyDensity psi, double mean_stress) {
  psi.p = mean_stress;
  return psi;
}

}  // namespace

CellLaw cell_law(const Settings& settings, const LameConstants& lame) {
  if (settings.element == Element::q1)
    return {
        .law = settings.law, .psi = energy_density(Part::whole, lame), .bulk_modulus = 0};
  return {.law = settings.law,
          .psi = energy_density(Part::shape, lame),
          .bulk_modulus = energy_density(Part::volumetric, lame).b};
}

CellState cell_state(const CellLaw& law, const Cell& cell, const CellVectors& u) {
  const double t = mean_trace(law.law, cell, u);
  const EnergyDensity psi = with_mean_stress(law.psi, law.bulk_modulus * t);
  CellState state{.energy = cell.volume * law.bulk_modulus / 2 * t * t,
                  .forces = CellVectors::Zero(),
                  .smallest_jacobian = std::numeric_limits<double>::infinity(),
                  .gradient_square = 0};
  for (const GaussPoint& point : cell.points) {
    const Matrix3 H = displacement_gradient(u, point);
    state.energy += point.weight * energy(law.law, law.psi, H);
    state.forces += point.weight * stress(law.law, psi, H) * point.gradients;
    state.smallest_jacobian =
        std::min(state.smallest_jacobian, (H + Matrix3::Identity()).determinant());
    state.gradient_square += point.weight * H.squaredNorm();
  }
  return state;
}

CellMatrix cell_tangent(const CellLaw& law, const Cell& cell, const CellVectors& u) {
  const EnergyDensity psi =
      with_mean_stress(law.psi, law.bulk_modulus * mean_trace(law.law, cell, u));
  CellVectors c = CellVectors::Zero();
  CellMatrix K = CellMatrix::Zero();
  for (const GaussPoint& point : cell.points) {
    const CellVectors& g = point.gradients;
    const Matrix3 H = displacement_gradient(u, point);
    c += point.weight * trace_derivative(law.law, H) * g;
    const Matrix9 A = point.weight * tangent(law.law, psi, H);
    for (Eigen::Index b = 0; b < 8; ++b) {
      const Eigen::Matrix<double, 9, 3> stress_change = g(0, b) * A.leftCols<3>() +
                                                        g(1, b) * A.middleCols<3>(3) +
                                                        g(2, b) * A.rightCols<3>();
      for (Eigen::Index a = 0; a <= b; ++a)  // the upper triangle; mirrored below
        K.block<3, 3>(3 * a, 3 * b) += g(0, a) * stress_change.topRows<3>() +
                                       g(1, a) * stress_change.middleRows<3>(3) +
                                       g(2, a) * stress_change.bottomRows<3>();
    }
  }
  K.triangularView<Eigen::StrictlyLower>() = K.transpose();
  K += law.bulk_modulus / cell.volume * c.reshaped() * c.reshaped().transpose();
  return K;
}

}  // namespace springcheck::fem_reference
