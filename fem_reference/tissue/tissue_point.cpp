#include "fem_reference/tissue/tissue_point.hpp"

#include <Eigen/LU>
#include <cmath>

namespace springcheck::fem_reference {
namespace {

using tissue::contraction;
using tissue::SymmetricTensor;

SymmetricTensor symmetric(const Matrix3& a) {
  return tissue::symmetric_tensor((a + a.transpose()) / 2);
}

/// A B A of symmetric tensors.
SymmetricTensor on_both_sides(const SymmetricTensor& a, const SymmetricTensor& b) {
  const Matrix3 A = tissue::matrix_of(a);
  return symmetric(A * tissue::matrix_of(b) * A);
}

/// The law at Cm, and its derivative.
class SolidAtPoint {
 public:
  SolidAtPoint(const tissue::Solid& solid, const tissue::MemoryStep& step,
               std::span<const double> state, const SymmetricTensor& C)
      : C_(C),
        inverse_(tissue::inverse(C)),
        J_(std::sqrt(tissue::determinant(C))),
        stress_(tissue::stress_after(solid, step, state, C)),
        tangent_(tissue::tangent_after(solid, step, state, C)) {}

  [[nodiscard]] SymmetricTensor stress() const {
    return tissue::second_piola_kirchhoff(stress_, C_);
  }

  /// dS = d strands + d(J v C^-1).
  [[nodiscard]] SymmetricTensor stress_change(const SymmetricTensor& dC) const {
    const double dJ = J_ / 2 * contraction(inverse_, dC);
    const double dv = tangent_.volume.dot(dC);
    return tangent_.strands * dC + (dJ * stress_.volume + J_ * dv) * inverse_ -
           J_ * stress_.volume * on_both_sides(inverse_, dC);
  }

 private:
  SymmetricTensor C_, inverse_;
  double J_;
  tissue::PointStress stress_;
  tissue::PointTangent tangent_;
};

}  // namespace

SymmetricTensor with_volume(const Matrix3& F, double cell_jacobian) {
  const double s = std::pow(cell_jacobian / F.determinant(), 2. / 3);
  return s * symmetric(F.transpose() * F);
}

TissuePointStress stress_after(const tissue::Solid& solid, const tissue::MemoryStep& step,
                               std::span<const double> state, const Matrix3& F,
                               double cell_jacobian) {
  const SymmetricTensor C = with_volume(F, cell_jacobian);
  const tissue::PointStress at = tissue::stress_after(solid, step, state, C);
  const SymmetricTensor S = tissue::second_piola_kirchhoff(at, C);
  const double s = std::pow(cell_jacobian / F.determinant(), 2. / 3);
  const double t = contraction(S, C);
  return {.shape = s * (S - t / 3 * tissue::inverse(C)),
          .pressure = t / (3 * cell_jacobian),
          .strands = at.strands};
}

TissuePointTangent tangent_after(const tissue::Solid& solid,
                                 const tissue::MemoryStep& step,
                                 std::span<const double> state, const Matrix3& F,
                                 double cell_jacobian) {
  const double Jm = cell_jacobian, s = std::pow(Jm / F.determinant(), 2. / 3);
  const SymmetricTensor own = symmetric(F.transpose() * F), Cm = s * own;
  const SymmetricTensor own_inverse = tissue::inverse(own), inverse = own_inverse / s;
  const SolidAtPoint law(solid, step, state, Cm);
  const SymmetricTensor S = law.stress();
  const double t = contraction(S, Cm);
  const SymmetricTensor shape = s * (S - t / 3 * inverse);

  struct Change {
    SymmetricTensor shape;
    double pressure;
  };
  const auto change = [&](const SymmetricTensor& dC, double dJm) -> Change {
    const double ds_of_s = 2. / 3 * (dJm / Jm - contraction(own_inverse, dC) / 2);
    const SymmetricTensor dCm = s * (dC + ds_of_s * own);
    const SymmetricTensor dS = law.stress_change(dCm);
    const double dt = contraction(dS, Cm) + contraction(S, dCm);
    return {.shape = ds_of_s * shape +
                     s * (dS - dt / 3 * inverse + t / 3 * on_both_sides(inverse, dCm)),
            .pressure = dt / (3 * Jm) - t / (3 * Jm * Jm) * dJm};
  };

  TissuePointTangent tangent{};
  const Matrix3 shape_matrix = tissue::matrix_of(shape);
  for (int L = 0; L < 3; ++L)
    for (int k = 0; k < 3; ++k) {
      Matrix3 dF = Matrix3::Zero();
      dF(k, L) = 1;
      const SymmetricTensor dC =
          tissue::symmetric_tensor(F.transpose() * dF + dF.transpose() * F);
      const Matrix3 dP = dF * shape_matrix + F * tissue::matrix_of(change(dC, 0).shape);
      tangent.by_gradient.col(k + 3 * L) = dP.reshaped();
    }
  const Change by_jacobian = change(SymmetricTensor::Zero(), 1);
  tangent.mixed = F * tissue::matrix_of(by_jacobian.shape);
  tangent.pressure_by_jacobian = by_jacobian.pressure;
  return tangent;
}

}  // namespace springcheck::fem_reference
