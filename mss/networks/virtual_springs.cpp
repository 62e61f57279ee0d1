#include "mss/networks/virtual_springs.hpp"

#include "mss/networks/isochoric_springs.hpp"

namespace springcheck::mss {
namespace {

struct StretchedAxis {
  Vector3 n;
  double weight;
  Vector3 d;  // F n
  double length;
  double strain;  // s, from H to keep the digits of small strains
};

template <class Visit>
void for_each_axis(Axes which, StrainMeasure measure, const Matrix3& H, Visit&& visit) {
  for (const auto& [n, weight] : all_of(which)) {
    const Vector3 move = H * n, d = n + move;
    const double length = d.norm();
    visit(StretchedAxis{.n = n,
                        .weight = weight,
                        .d = d,
                        .length = length,
                        .strain = elongation(measure, 1, (n + d).dot(move), length, 1)});
  }
}

/// The factor of d d^T/|d|^3 in the tangent of one axis: |d| (b - a).
double along_factor(StrainMeasure measure, double strain, double length) {
  if (measure == StrainMeasure::engineering) return 1;
  const auto [first, second] = elongation_slopes(measure, 1, length);
  return length * (first * first + strain * second) - strain * first;
}

}  // namespace

AxisValues axis_strains(Axes axes, const Matrix3& H) {
  AxisValues strains(static_cast<Eigen::Index>(all_of(axes).size()));
  Eigen::Index next = 0;
  for_each_axis(axes, StrainMeasure::engineering, H,
                [&](const StretchedAxis& axis) { strains[next++] = axis.strain; });
  return strains;
}

VolumeModuli VirtualSprings::moduli_of_volume() const {
  VolumeModuli moduli = volume_moduli;
  if (measure == StrainMeasure::hencky) moduli.kappa += 5 * shear_modulus / 3;
  return moduli;
}

double VirtualSprings::energy(const Matrix3& H) const {
  double energy = 0;
  if (shear_modulus != 0 && measure == StrainMeasure::hencky)
    energy = IsochoricSprings{shear_modulus, axes}.energy(H);
  else if (shear_modulus != 0)
    for_each_axis(axes, measure, H, [&](const StretchedAxis& axis) {
      const double s = axis.strain;
      energy += axis.weight * shear_modulus / 2 * s * s;
    });
  if (const VolumeModuli moduli = moduli_of_volume(); moduli.act())
    energy += volume_energy(measure, moduli, volume_change(measure, H));
  return energy;
}

Matrix3 VirtualSprings::stress(const Matrix3& H) const {
  Matrix3 P = Matrix3::Zero();
  if (shear_modulus != 0 && measure == StrainMeasure::hencky)
    P = IsochoricSprings{shear_modulus, axes}.stress(H);
  else if (shear_modulus != 0)
    for_each_axis(axes, measure, H, [&](const StretchedAxis& axis) {
      if (axis.length == 0) return;
      const double s = axis.strain,
                   slope = elongation_slopes(measure, 1, axis.length).first;
      P += (axis.weight * shear_modulus * s * slope / axis.length * axis.d) *
           axis.n.transpose();
    });
  if (const VolumeModuli moduli = moduli_of_volume(); moduli.act()) {
    const VolumePull pull = volume_pull(measure, moduli, volume_change(measure, H));
    P += pull.modulus * pull.first * volume_gradient(measure, H);
  }
  return P;
}

Matrix9 VirtualSprings::tangent(const Matrix3& H) const {
  Matrix9 A = Matrix9::Zero();
  if (shear_modulus != 0 && measure == StrainMeasure::hencky)
    A = IsochoricSprings{shear_modulus, axes}.tangent(H);
  else if (shear_modulus != 0)
    for_each_axis(axes, measure, H, [&](const StretchedAxis& axis) {
      if (axis.length == 0) return;
      const double s = axis.strain,
                   slope = elongation_slopes(measure, 1, axis.length).first;
      const Matrix3 block =
          axis.weight * shear_modulus *
          (s * slope / axis.length * Matrix3::Identity() +
           along_factor(measure, s, axis.length) * axis.d * axis.d.transpose() /
               (axis.length * axis.length * axis.length));
      for (Eigen::Index J = 0; J < 3; ++J)
        for (Eigen::Index L = 0; L < 3; ++L)
          A.block<3, 3>(3 * J, 3 * L) += axis.n[J] * axis.n[L] * block;
    });
  if (const VolumeModuli moduli = moduli_of_volume(); moduli.act()) {
    const auto [modulus, first, second] =
        volume_pull(measure, moduli, volume_change(measure, H));
    const Matrix3 gradient = volume_gradient(measure, H);
    A += modulus * (second * gradient.reshaped() * gradient.reshaped().transpose() +
                    first * volume_hessian(measure, H));
  }
  return A;
}

}  // namespace springcheck::mss
