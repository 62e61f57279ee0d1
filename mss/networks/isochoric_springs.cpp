#include "mss/networks/isochoric_springs.hpp"

#include <cmath>
#include <limits>

#include "meshing/basics/logarithm.hpp"

namespace springcheck::mss {
namespace {

constexpr double b = 4.5;

struct IsochoricAxis {
  Vector3 n;
  double weight;
  Vector3 d;              // F n
  double length_squared;  // |d|^2
  double stretch;         // q, from H to keep the digits of small strains
};

template <class Visit>
void for_each_isochoric_axis(Axes axes, const Matrix3& H, double volume_change,
                             Visit&& visit) {
  const double third = std::log1p(volume_change) / 3;
  for (const auto& [n, weight] : all_of(axes)) {
    const Vector3 move = H * n, d = n + move;
    visit(IsochoricAxis{.n = n,
                        .weight = weight,
                        .d = d,
                        .length_squared = d.squaredNorm(),
                        .stretch = std::log1p((n + d).dot(move)) / 2 - third});
  }
}

Eigen::Vector<double, 9> outer_product(const Vector3& d, const Vector3& n) {
  return (d * n.transpose()).reshaped();
}

}  // namespace

double IsochoricSprings::energy(const Matrix3& H) const {
  const double change = volume_change(H);
  if (!(change > -1)) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for_each_isochoric_axis(axes, H, change, [&](const IsochoricAxis& axis) {
    // e^x - 1 - x of x = -b q, where the difference keeps its digits.
    sum -= axis.weight * log1p_minus(std::expm1(-b * axis.stretch)) / (b * b);
  });
  return shear_modulus * sum;
}

Matrix3 IsochoricSprings::stress(const Matrix3& H) const {
  const double change = volume_change(H);
  if (!(change > -1)) return Matrix3::Zero();
  Matrix3 along = Matrix3::Zero();
  double pressure = 0;
  for_each_isochoric_axis(axes, H, change, [&](const IsochoricAxis& axis) {
    const double pull = axis.weight * shear_modulus * -std::expm1(-b * axis.stretch) / b;
    along += (pull / axis.length_squared * axis.d) * axis.n.transpose();
    pressure += pull / 3;
  });
  return along - pressure / (1 + change) * cofactor(H);
}

Matrix9 IsochoricSprings::tangent(const Matrix3& H) const {
  const double change = volume_change(H);
  if (!(change > -1)) return Matrix9::Zero();
  using Vector9 = Eigen::Vector<double, 9>;
  const Vector9 of_volume = cofactor(H).reshaped() / (1 + change);  // d(ln J)/dF
  Matrix9 A = Matrix9::Zero();
  double pressure = 0;
  for_each_isochoric_axis(axes, H, change, [&](const IsochoricAxis& axis) {
    const double fall = std::expm1(-b * axis.stretch),
                 weight = axis.weight * shear_modulus, pull = weight * -fall / b;
    const Vector9 of_length = outer_product(axis.d, axis.n) / axis.length_squared,
                  s = of_length - of_volume / 3;
    A += weight * (1 + fall) * s * s.transpose() -
         2 * pull * of_length * of_length.transpose();
    for (Eigen::Index J = 0; J < 3; ++J)
      for (Eigen::Index L = 0; L < 3; ++L)
        A.block<3, 3>(3 * J, 3 * L).diagonal().array() +=
            pull / axis.length_squared * axis.n[J] * axis.n[L];
    pressure += pull / 3;
  });
  return A - pressure *
                 (volume_hessian(H) / (1 + change) - of_volume * of_volume.transpose());
}

}  // namespace springcheck::mss
