#include "fem_reference/laws/hooke.hpp"

namespace springcheck::fem_reference {
namespace {

Matrix3 deviatoric_strain(const Matrix3& H) {
  return (H + H.transpose()) / 2 - H.trace() / 3 * Matrix3::Identity();
}

}  // namespace

double Hooke::energy(const Matrix3& displacement_gradient) const {
  return shear_modulus * deviatoric_strain(displacement_gradient).squaredNorm();
}

Matrix3 Hooke::stress(const Matrix3& displacement_gradient) const {
  return 2 * shear_modulus * deviatoric_strain(displacement_gradient);
}

Matrix9 Hooke::tangent(const Matrix3& /*displacement_gradient*/) const {
  Matrix9 A = shear_modulus * Matrix9::Identity();
  for (int i = 0; i < 3; ++i)
    for (int J = 0; J < 3; ++J) {
      A(i + 3 * J, J + 3 * i) += shear_modulus;
      A(i + 3 * i, J + 3 * J) -= 2 * shear_modulus / 3;
    }
  return A;
}

Dilatation Hooke::dilatation(const Matrix3& displacement_gradient) {
  return small_strain_trace(displacement_gradient);
}

VolumetricEnergy Hooke::volumetric_energy(double dilatation) const {
  return quadratic(bulk_modulus, dilatation);
}

Hooke hooke(const LameConstants& lame) {
  return {.shear_modulus = lame.mu, .bulk_modulus = bulk_modulus(lame)};
}

}  // namespace springcheck::fem_reference
