#include "mss/networks/virtual_springs.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace springcheck::mss {
namespace {

using std::numbers::phi;

struct Axis {
  Vector3 n;
  double weight;  // w/mu
};

/// The icosahedron's axes: (phi, 1, 0), (phi, -1, 0) and cyclic, normalised. Then the
/// dodecahedron's: (0, 1/phi, phi), (0, -1/phi, phi) and cyclic, (1, 1, 1) and its
/// reflections.
std::array<Axis, 16> axes_with(double of_icosahedron, double of_dodecahedron) {
  std::array<Axis, 16> axes;
  std::size_t next = 0;
  const auto add = [&](const Vector3& along, double weight) {
    axes[next++] = {.n = along.normalized(), .weight = weight};
  };
  const auto turned = [](Eigen::Index by, double first, double second, double third) {
    Vector3 v;
    v[by] = first;
    v[(by + 1) % 3] = second;
    v[(by + 2) % 3] = third;
    return v;
  };
  for (Eigen::Index by = 0; by < 3; ++by)
    for (const double side : {1., -1.}) add(turned(by, phi, side, 0), of_icosahedron);
  for (Eigen::Index by = 0; by < 3; ++by)
    for (const double side : {1., -1.})
      add(turned(by, 0, side / phi, phi), of_dodecahedron);
  for (const double x : {1., -1.})
    for (const double y : {1., -1.}) add({x, y, 1}, of_dodecahedron);
  return axes;
}

std::span<const Axis> all_of(Axes which) {
  static const std::array six = axes_with(15. / 6, 0),
                          sixteen = axes_with(15. * 25 / 420, 15. * 27 / 420);
  return which == Axes::six ? std::span(six).first<6>() : std::span<const Axis>(sixteen);
}

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

double VirtualSprings::energy(const Matrix3& H) const {
  double energy = 0;
  if (shear_modulus != 0)
    for_each_axis(axes, measure, H, [&](const StretchedAxis& axis) {
      const double s = axis.strain;
      energy += axis.weight * shear_modulus / 2 * s * s;
    });
  if (volume_modulus != 0)
    energy += volume_energy(measure, volume_modulus, volume_change(measure, H));
  return energy;
}

Matrix3 VirtualSprings::stress(const Matrix3& H) const {
  Matrix3 P = Matrix3::Zero();
  if (shear_modulus != 0)
    for_each_axis(axes, measure, H, [&](const StretchedAxis& axis) {
      if (axis.length == 0) return;
      const double s = axis.strain,
                   slope = elongation_slopes(measure, 1, axis.length).first;
      P += (axis.weight * shear_modulus * s * slope / axis.length * axis.d) *
           axis.n.transpose();
    });
  if (volume_modulus != 0)
    P += volume_modulus * volume_pull(measure, volume_change(measure, H)).first *
         volume_gradient(measure, H);
  return P;
}

Matrix9 VirtualSprings::tangent(const Matrix3& H) const {
  Matrix9 A = Matrix9::Zero();
  if (shear_modulus != 0)
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
  if (volume_modulus != 0) {
    const auto [first, second] = volume_pull(measure, volume_change(measure, H));
    const Matrix3 gradient = volume_gradient(measure, H);
    A +=
        volume_modulus * (second * gradient.reshaped() * gradient.reshaped().transpose() +
                          first * volume_hessian(measure, H));
  }
  return A;
}

}  // namespace springcheck::mss
