#include "fem_reference/laws/dilatation.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace springcheck::fem_reference {

Dilatation small_strain_trace(const Matrix3& displacement_gradient) {
  return {.value = displacement_gradient.trace(),
          .first = Matrix3::Identity(),
          .second = Matrix9::Zero()};
}

Dilatation green_strain_trace(const Matrix3& displacement_gradient) {
  const Matrix3& H = displacement_gradient;
  return {.value = H.trace() + H.squaredNorm() / 2,
          .first = Matrix3::Identity() + H,
          .second = Matrix9::Identity()};
}

Dilatation volume_change(const Matrix3& displacement_gradient) {
  const Matrix3& H = displacement_gradient;
  const double trace = H.trace();
  const Matrix3 F = Matrix3::Identity() + H;
  Dilatation t{.value = trace +
                        (trace * trace - H.cwiseProduct(H.transpose()).sum()) / 2 +
                        H.determinant(),
               .first = {},
               .second = Matrix9::Zero()};
  for (int J = 0; J < 3; ++J) {
    const int K = (J + 1) % 3, L = (J + 2) % 3;
    t.first.col(J) = F.col(K).cross(F.col(L));
    // d(F_K x F_L) = -[F_L]x dF_K + [F_K]x dF_L, [v]x the matrix of the product v x .
    for (int i = 0; i < 3; ++i) {
      const int k = (i + 1) % 3, l = (i + 2) % 3;
      t.second(k + 3 * J, l + 3 * K) = F(i, L);
      t.second(l + 3 * J, k + 3 * K) = -F(i, L);
      t.second(k + 3 * J, l + 3 * L) = -F(i, K);
      t.second(l + 3 * J, k + 3 * L) = F(i, K);
    }
  }
  return t;
}

VolumetricEnergy quadratic(double modulus, double dilatation) {
  return {.value = modulus / 2 * dilatation * dilatation,
          .first = modulus * dilatation,
          .second = modulus};
}

VolumetricEnergy logarithmic(double modulus, double dilatation) {
  const double J = 1 + dilatation, log_J = std::log1p(dilatation);
  return {.value = modulus / 2 * log_J * log_J,
          .first = modulus * log_J / J,
          .second = modulus * (1 - log_J) / (J * J)};
}

VolumetricEnergy cubic_logarithmic(double cubic_modulus, double dilatation) {
  const double J = 1 + dilatation, log_J = std::log1p(dilatation);
  constexpr double p = std::numbers::ln2;
  const double turned = log_J + 2 * p;
  double C = log_J * log_J * log_J / 3, slope = log_J * log_J, curvature = 2 * log_J;
  if (log_J < -p) {
    C = 2 * p * p * (log_J + p) - turned * turned * turned / 3;
    slope = 2 * p * p - turned * turned;
    curvature = -2 * turned;
  }
  return {.value = cubic_modulus * C,
          .first = cubic_modulus * slope / J,
          .second = cubic_modulus * (curvature - slope) / (J * J)};
}

}  // namespace springcheck::fem_reference
