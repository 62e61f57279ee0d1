#include "fem_reference/laws/hencky.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace springcheck::fem_reference {
namespace {

using Array3 = Eigen::Array3d;

/// Principal stretches, from the eigenvalues of E so that a small strain keeps its
/// digits.
struct Principal {
  Matrix3 directions;      // N_a, as columns
  Array3 green_strain;     // E_a
  Array3 stretch_squared;  // l_a^2
  Array3 deviator;         // e_a - ln J/3
};

Principal principal(const Matrix3& H) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(
      (H + H.transpose() + H.transpose() * H) / 2);
  Principal p{.directions = eigen.eigenvectors(),
              .green_strain = eigen.eigenvalues().array(),
              .stretch_squared = 1 + 2 * eigen.eigenvalues().array(),
              .deviator = {}};
  const Array3 e = (2 * p.green_strain).log1p() / 2;
  p.deviator = e - e.mean();
  return p;
}

/// log(1 + x)/x.
double log1p_over(double x) {
  return x == 0 ? 1 : std::log1p(x) / x;
}

}  // namespace

ShapeState Hencky::shape_state(const Matrix3& displacement_gradient) const {
  const Principal p = principal(displacement_gradient);
  const Matrix3 S =
      p.directions *
      (2 * shear_modulus * p.deviator / p.stretch_squared).matrix().asDiagonal() *
      p.directions.transpose();
  return {.energy = shear_modulus * p.deviator.matrix().squaredNorm(),
          .stress = S + displacement_gradient * S};
}

double Hencky::energy(const Matrix3& displacement_gradient) const {
  return shape_state(displacement_gradient).energy;
}

Matrix3 Hencky::stress(const Matrix3& displacement_gradient) const {
  return shape_state(displacement_gradient).stress;
}

Matrix9 Hencky::tangent(const Matrix3& displacement_gradient) const {
  const Principal p = principal(displacement_gradient);
  const Matrix3& N = p.directions;
  const Matrix3 FN = N + displacement_gradient * N;
  const Array3 kirchhoff = 2 * shear_modulus * p.deviator;
  const Array3& l2 = p.stretch_squared;

  Eigen::Matrix<double, 9, 9> v;  // v_ab as column a + 3b
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      v.col(a + 3 * b) = (FN.col(a) * N.col(b).transpose()).reshaped();

  Matrix9 moduli = Matrix9::Zero();  // in the basis of v
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      moduli(a + 3 * a, b + 3 * b) +=
          (a == b ? 4 * shear_modulus / 3 - 2 * kirchhoff[a] : -2 * shear_modulus / 3) /
          (l2[a] * l2[b]);
      if (a == b) continue;
      const double x = 2 * (p.green_strain[a] - p.green_strain[b]) / l2[b];
      const double g =
          2 * (shear_modulus * log1p_over(x) - kirchhoff[b]) / (l2[a] * l2[b]);
      moduli(a + 3 * b, a + 3 * b) += g / 2;
      moduli(a + 3 * b, b + 3 * a) += g / 2;
    }
  Matrix9 A = v * moduli * v.transpose();
  const Matrix3 S = N * (kirchhoff / l2).matrix().asDiagonal() * N.transpose();
  for (int J = 0; J < 3; ++J)
    for (int L = 0; L < 3; ++L) A.block<3, 3>(3 * J, 3 * L).diagonal().array() += S(J, L);
  return A;
}

Dilatation Hencky::dilatation(const Matrix3& displacement_gradient) {
  return volume_change(displacement_gradient);
}

VolumetricEnergy Hencky::volumetric_energy(double dilatation) const {
  return logarithmic(bulk_modulus, dilatation);
}

Hencky hencky(const LameConstants& lame) {
  return {.shear_modulus = lame.mu, .bulk_modulus = bulk_modulus(lame)};
}

}  // namespace springcheck::fem_reference
