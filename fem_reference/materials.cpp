#include "fem_reference/materials.hpp"

namespace springcheck::fem_reference {
namespace {

/// S = dpsi/de.
Matrix3 conjugate_stress(const EnergyDensity& psi, const Matrix3& e) {
  return 2 * psi.a * e + (psi.b * e.trace() + psi.p) * Matrix3::Identity();
}

}  // namespace

Matrix3 strain(Law law, const Matrix3& displacement_gradient) {
  const Matrix3& H = displacement_gradient;
  const Matrix3 twice = H + H.transpose();
  if (law == Law::hooke) return twice / 2;
  return (twice + H.transpose() * H) / 2;
}

EnergyDensity energy_density(Part part, const LameConstants& lame) {
  const auto& [lambda, mu] = lame;
  switch (part) {
    case Part::shape:
      return {.a = mu, .b = -2 * mu / 3, .p = 0};
    case Part::volumetric:
      return {.a = 0, .b = lambda + 2 * mu / 3, .p = 0};
    case Part::whole:
      break;
  }
  return {.a = mu, .b = lambda, .p = 0};
}

double energy(Law law, const EnergyDensity& psi, const Matrix3& displacement_gradient) {
  const Matrix3 e = strain(law, displacement_gradient);
  return psi.a * e.squaredNorm() + (psi.b / 2 * e.trace() + psi.p) * e.trace();
}

Matrix3 stress(Law law, const EnergyDensity& psi, const Matrix3& displacement_gradient) {
  const Matrix3 S = conjugate_stress(psi, strain(law, displacement_gradient));
  if (law == Law::hooke) return S;
  return S + displacement_gradient * S;
}

Matrix9 tangent(Law law, const EnergyDensity& psi, const Matrix3& displacement_gradient) {
  const Matrix3 F = trace_derivative(law, displacement_gradient);
  const Matrix3 FFt = F * F.transpose();
  Matrix3 S = Matrix3::Zero();
  if (law == Law::st_venant_kirchhoff)
    S = conjugate_stress(psi, strain(law, displacement_gradient));
  Matrix9 A;
  for (int L = 0; L < 3; ++L)
    for (int J = 0; J < 3; ++J) {
      auto block = A.block<3, 3>(3 * J, 3 * L);  // over i and k
      block = psi.a * F.col(L) * F.col(J).transpose() +
              psi.b * F.col(J) * F.col(L).transpose() + S(J, L) * Matrix3::Identity();
      if (J == L) block += psi.a * FFt;
    }
  return A;
}

Matrix3 trace_derivative(Law law, const Matrix3& displacement_gradient) {
  if (law == Law::hooke) return Matrix3::Identity();
  return Matrix3::Identity() + displacement_gradient;
}

}  // namespace springcheck::fem_reference
