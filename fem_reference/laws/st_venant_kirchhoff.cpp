#include "fem_reference/laws/st_venant_kirchhoff.hpp"

namespace springcheck::fem_reference {
namespace {

Matrix3 deviatoric_green_strain(const Matrix3& H) {
  const Matrix3 E = (H + H.transpose() + H.transpose() * H) / 2;
  return E - E.trace() / 3 * Matrix3::Identity();
}

}  // namespace

double StVenantKirchhoff::energy(const Matrix3& displacement_gradient) const {
  return shear_modulus * deviatoric_green_strain(displacement_gradient).squaredNorm();
}

Matrix3 StVenantKirchhoff::stress(const Matrix3& displacement_gradient) const {
  const Matrix3 S = 2 * shear_modulus * deviatoric_green_strain(displacement_gradient);
  return S + displacement_gradient * S;
}

Matrix9 StVenantKirchhoff::tangent(const Matrix3& displacement_gradient) const {
  const double mu = shear_modulus;
  const Matrix3 F = Matrix3::Identity() + displacement_gradient;
  const Matrix3 FFt = F * F.transpose();
  const Matrix3 S = 2 * mu * deviatoric_green_strain(displacement_gradient);
  Matrix9 A;
  for (int L = 0; L < 3; ++L)
    for (int J = 0; J < 3; ++J) {
      auto block = A.block<3, 3>(3 * J, 3 * L);  // over i and k
      block = mu * F.col(L) * F.col(J).transpose() -
              2 * mu / 3 * F.col(J) * F.col(L).transpose() +
              S(J, L) * Matrix3::Identity();
      if (J == L) block += mu * FFt;
    }
  return A;
}

Dilatation StVenantKirchhoff::dilatation(const Matrix3& displacement_gradient) {
  return green_strain_trace(displacement_gradient);
}

VolumetricEnergy StVenantKirchhoff::volumetric_energy(double dilatation) const {
  return quadratic(bulk_modulus, dilatation);
}

StVenantKirchhoff st_venant_kirchhoff(const LameConstants& lame) {
  return {.shear_modulus = lame.mu, .bulk_modulus = bulk_modulus(lame)};
}

}  // namespace springcheck::fem_reference
