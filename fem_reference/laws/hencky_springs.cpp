#include "fem_reference/laws/hencky_springs.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "fem_reference/laws/dilatation.hpp"
#include "meshing/basics/logarithm.hpp"

namespace springcheck::fem_reference {
namespace {

/// e, e' and e'' of q.
struct SpringEnergy {
  double value, first, second;
};

SpringEnergy of_whole_stretch(double q) {
  const double x = std::expm1(2 * q), l2 = 1 + x, fall = 1 + 0.3 * x;  // x = l^2 - 1
  const double first = x / (2 * l2 * fall);
  return {.value = (x * x / (l2 * fall) + log1p_minus(0.7 * x / fall) / (0.7 * 0.7)) / 4,
          .first = first,
          .second = 1 / (l2 * fall) - 0.6 * l2 * first / fall};
}

SpringEnergy of_isochoric_stretch(double q) {
  const double x = std::expm1(-4.5 * q);
  // x + 4.5 q, where the difference keeps its digits.
  return {.value = -log1p_minus(x) / (4.5 * 4.5), .first = -x / 4.5, .second = 1 + x};
}

struct HenckyDirection {
  Eigen::Vector3d n;
  double weight;
  Eigen::Vector3d m;
  double length;
  SpringEnergy energy;
};

template <class Visit>
void for_each_direction(const HenckySprings& law, const Matrix3& H, Visit&& visit) {
  const bool is_whole = law.stretch == SpringStretch::whole;
  const double volume_part = is_whole ? 0 : std::log1p(volume_change(H).value) / 3;
  for (const auto& [n, w] : law.springs) {
    const Eigen::Vector3d Hn = H * n, d = n + Hn;
    const double q = std::log1p(2 * n.dot(Hn) + Hn.squaredNorm()) / 2 - volume_part;
    visit(HenckyDirection{
        .n = n,
        .weight = w,
        .m = d.normalized(),
        .length = d.norm(),
        .energy = is_whole ? of_whole_stretch(q) : of_isochoric_stretch(q)});
  }
}

double theta(SpringStretch stretch) {
  return stretch == SpringStretch::whole ? 0 : 1. / 3;
}

}  // namespace

double HenckySprings::energy(const Matrix3& displacement_gradient) const {
  double sum = 0;
  for_each_direction(*this, displacement_gradient, [&](const HenckyDirection& spring) {
    sum += spring.weight * spring.energy.value;
  });
  return sum;
}

Matrix3 HenckySprings::stress(const Matrix3& displacement_gradient) const {
  const Matrix3 part_of_volume = theta(stretch) * Matrix3::Identity();
  Matrix3 kirchhoff = Matrix3::Zero();
  for_each_direction(*this, displacement_gradient, [&](const HenckyDirection& spring) {
    kirchhoff += spring.weight * spring.energy.first *
                 (spring.m * spring.m.transpose() - part_of_volume);
  });
  return kirchhoff * (Matrix3::Identity() + displacement_gradient).inverse().transpose();
}

// Column by column, from the change of each entry of F:
//     dP = dtau F^-T - P dF^T F^-T
Matrix9 HenckySprings::tangent(const Matrix3& displacement_gradient) const {
  const Matrix3 F_inverse = (Matrix3::Identity() + displacement_gradient).inverse(),
                part_of_volume = theta(stretch) * Matrix3::Identity(),
                P = stress(displacement_gradient);
  Matrix9 A;
  for (int L = 0; L < 3; ++L)
    for (int k = 0; k < 3; ++k)
      A.col(k + 3 * L) = -(P.col(L) * F_inverse.transpose().row(k)).reshaped();
  for_each_direction(*this, displacement_gradient, [&](const HenckyDirection& spring) {
    const auto& [n, w, m, length, e] = spring;
    for (int L = 0; L < 3; ++L)
      for (int k = 0; k < 3; ++k) {
        const double dq = n[L] / length * m[k] - theta(stretch) * F_inverse(L, k);
        const Eigen::Vector3d dm = n[L] / length * (Eigen::Vector3d::Unit(k) - m[k] * m);
        const Matrix3 change = w * (e.second * dq * (m * m.transpose() - part_of_volume) +
                                    e.first * (dm * m.transpose() + m * dm.transpose()));
        A.col(k + 3 * L) += (change * F_inverse.transpose()).reshaped();
      }
  });
  return A;
}

}  // namespace springcheck::fem_reference
