#include "fem_reference/laws/cauchy_born.hpp"

#include <cmath>
#include <numbers>

namespace springcheck::fem_reference {
namespace {

using Eigen::Vector3d;

/// Elongation |d| - 1 of the direction n, from H so that small strains keep their digits.
struct Stretched {
  Vector3d d;
  double length;
  double elongation;
};

Stretched stretched(const Vector3d& n, const Matrix3& H) {
  const Vector3d Hn = H * n, d = n + Hn;
  const double length = d.norm();
  return {.d = d,
          .length = length,
          .elongation = (2 * n.dot(Hn) + Hn.squaredNorm()) / (length + 1)};
}

struct Weights {
  double edge;
  double face_diagonal;
  double inner_diagonal;
};

Weights shear_modulus_weights(double mu, double A) {
  const double unit = mu / (3 * A + 4);
  return {.edge = (3 * A + 8) * unit,
          .face_diagonal = 6 * A * unit,
          .inner_diagonal = 9 * unit};
}

Weights baudet_weights(const Material& material) {
  const double E = material.young_modulus, nu = material.poisson_ratio;
  return {.edge = E * (4 * nu + 1) / (2 * (1 + nu)),
          .face_diagonal = 0,
          .inner_diagonal = 9 * E / (8 * (1 + nu))};
}

std::vector<SpringDirection> cubic_springs(const Weights& weights) {
  std::vector<SpringDirection> springs;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const bool first_of_pair = x > 0 || (x == 0 && (y > 0 || (y == 0 && z > 0)));
        if (!first_of_pair) continue;
        const int steps = std::abs(x) + std::abs(y) + std::abs(z);
        const double weight = steps == 1   ? weights.edge
                              : steps == 2 ? weights.face_diagonal
                                           : weights.inner_diagonal;
        if (weight != 0)
          springs.push_back(
              {.direction = Vector3d(x, y, z).normalized(), .weight = weight});
      }
  return springs;
}

std::vector<SpringDirection> icosahedral_springs(double mu) {
  std::vector<SpringDirection> springs;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1., -1.}) {
      Vector3d n = Vector3d::Zero();
      n[axis] = std::numbers::phi;
      n[(axis + 1) % 3] = sign;
      springs.push_back({.direction = n.normalized(), .weight = 5 * mu / 2});
    }
  return springs;
}

}  // namespace

Matrix3 lattice_to_body(LatticeDirection direction) {
  Matrix3 rows = Matrix3::Identity();
  switch (direction) {
    case LatticeDirection::d100:
      break;
    case LatticeDirection::d110:
      rows << 0, 0, 1, 1, -1, 0, 1, 1, 0;
      break;
    case LatticeDirection::d111:
      rows << 1, -1, 0, 1, 1, -2, 1, 1, 1;
      break;
  }
  return rows.rowwise().normalized();
}

double CauchyBorn::energy(const Matrix3& displacement_gradient) const {
  double sum = 0;
  for (const auto& [n, w] : springs) {
    const double elongation = stretched(n, displacement_gradient).elongation;
    sum += w / 2 * elongation * elongation;
  }
  return sum;
}

Matrix3 CauchyBorn::stress(const Matrix3& displacement_gradient) const {
  Matrix3 P = Matrix3::Zero();
  for (const auto& [n, w] : springs) {
    const auto [d, length, elongation] = stretched(n, displacement_gradient);
    P += w * elongation / length * d * n.transpose();
  }
  return P;
}

Matrix9 CauchyBorn::tangent(const Matrix3& displacement_gradient) const {
  Matrix9 A = Matrix9::Zero();
  for (const auto& [n, w] : springs) {
    const auto [d, length, elongation] = stretched(n, displacement_gradient);
    const Matrix3 block = w * (elongation / length * Matrix3::Identity() +
                               d * d.transpose() / (length * length * length));
    for (int L = 0; L < 3; ++L)
      for (int J = 0; J < 3; ++J) A.block<3, 3>(3 * J, 3 * L) += n[J] * n[L] * block;
  }
  return A;
}

Dilatation CauchyBorn::dilatation(const Matrix3& displacement_gradient) {
  return volume_change(displacement_gradient);
}

VolumetricEnergy CauchyBorn::volumetric_energy(double dilatation) const {
  return quadratic(volume_modulus, dilatation);
}

CauchyBorn cauchy_born(const Material& material, const Lattice& lattice) {
  const auto [lambda, mu] = lame_constants(material);
  const double spring_mu = lattice.constants == SpringConstants::from_young_modulus
                               ? 0.4 * material.young_modulus
                               : mu;
  CauchyBorn law{.springs = {}, .volume_modulus = lambda - mu};
  switch (lattice.springs) {
    case Springs::baudet:
      law.springs = cubic_springs(baudet_weights(material));
      law.volume_modulus = 0;
      break;
    case Springs::nfd:
      law.springs = cubic_springs(shear_modulus_weights(spring_mu, 0));
      break;
    case Springs::fd:
      law.springs =
          cubic_springs(shear_modulus_weights(spring_mu, lattice.diagonal_ratio));
      law.volume_modulus = 0;
      break;
    case Springs::cf:
      law.springs =
          cubic_springs(shear_modulus_weights(spring_mu, lattice.diagonal_ratio));
      break;
    case Springs::affine:
      law.springs = icosahedral_springs(spring_mu);
      break;
  }
  const Matrix3 turn = lattice_to_body(lattice.direction);
  for (SpringDirection& spring : law.springs) spring.direction = turn * spring.direction;
  return law;
}

}  // namespace springcheck::fem_reference
