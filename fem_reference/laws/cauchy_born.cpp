#include "fem_reference/laws/cauchy_born.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace springcheck::fem_reference {
namespace {

using Eigen::Vector3d;

/// A direction's strain s and its derivatives by the length.
struct Stretched {
  Vector3d d;
  double length;
  double strain, first, second;
};

/// The strain along n, computed from H so that small strains keep their digits.
Stretched stretched(SpringStrain strain, const Vector3d& n, const Matrix3& H) {
  const Vector3d Hn = H * n, d = n + Hn;
  const double length = d.norm(), squares = 2 * n.dot(Hn) + Hn.squaredNorm();
  Stretched now{.d = d,
                .length = length,
                .strain = squares / (length + 1),
                .first = 1,
                .second = 0};
  switch (strain) {
    case SpringStrain::engineering:
    case SpringStrain::hencky:  // HenckySprings
      break;
    case SpringStrain::green:
      now.strain = squares / 2 - green_strain_trace(H).value / 3;
      now.first = length;
      now.second = 1;
      break;
    case SpringStrain::logarithmic:
      now.strain = std::log1p(now.strain);
      now.first = 1 / length;
      now.second = -1 / (length * length);
      break;
  }
  return now;
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

std::vector<SpringDirection> springs_of_25_axes(double mu) {
  auto springs = cubic_springs({.edge = 8 * mu / 21,
                                .face_diagonal = 128 * mu / 189,
                                .inner_diagonal = 81 * mu / 128});
  for (int along = 0; along < 3; ++along)
    for (const double x : {1., -1.})
      for (const double y : {1., -1.}) {
        Vector3d axis(x, y, 3);
        std::rotate(axis.begin(), axis.begin() + along, axis.end());
        springs.push_back({.direction = axis.normalized(), .weight = 14641 * mu / 24192});
      }
  return springs;
}

/// The springs along the icosahedron's axes; 16 axes include the dodecahedron's.
std::vector<SpringDirection> virtual_springs(double mu, int axes) {
  if (axes == 25) return springs_of_25_axes(mu);
  using std::numbers::phi;
  const bool has_both = axes == 16;
  std::vector<SpringDirection> springs;
  const auto add = [&](const Vector3d& axis, double weight) {
    springs.push_back({.direction = axis.normalized(), .weight = weight});
  };
  const auto add_cyclic = [&](double first, double second, double third, double weight) {
    for (int by = 0; by < 3; ++by)
      for (const double sign : {1., -1.}) {
        Vector3d axis;
        axis[by] = first;
        axis[(by + 1) % 3] = sign * second;
        axis[(by + 2) % 3] = third;
        add(axis, weight);
      }
  };
  add_cyclic(phi, 1, 0, has_both ? 25 * mu / 28 : 5 * mu / 2);
  if (!has_both) return springs;
  const double weight = 27 * mu / 28;
  add_cyclic(0, 1 / phi, phi, weight);
  for (const double x : {1., -1.})
    for (const double y : {1., -1.}) add({x, y, 1}, weight);
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

double CauchyBorn::springs_bulk_modulus() const {
  double sum = 0;
  for (const SpringDirection& spring : springs) sum += spring.weight;
  return sum / 9;
}

double CauchyBorn::energy(const Matrix3& displacement_gradient) const {
  if (strain == SpringStrain::hencky)
    return HenckySprings{springs, stretch}.energy(displacement_gradient);
  double sum = 0;
  for (const auto& [n, w] : springs) {
    const double s = stretched(strain, n, displacement_gradient).strain;
    sum += w / 2 * s * s;
  }
  return sum;
}

Matrix3 CauchyBorn::stress(const Matrix3& displacement_gradient) const {
  if (strain == SpringStrain::hencky)
    return HenckySprings{springs, stretch}.stress(displacement_gradient);
  Matrix3 P = Matrix3::Zero();
  for (const auto& [n, w] : springs) {
    const Stretched now = stretched(strain, n, displacement_gradient);
    P += w * now.strain * now.first / now.length * now.d * n.transpose();
  }
  return P;
}

Matrix9 CauchyBorn::tangent(const Matrix3& displacement_gradient) const {
  if (strain == SpringStrain::hencky)
    return HenckySprings{springs, stretch}.tangent(displacement_gradient);
  Matrix9 A = Matrix9::Zero();
  for (const auto& [n, w] : springs) {
    const auto [d, length, s, first, second] =
        stretched(strain, n, displacement_gradient);
    const double along = strain == SpringStrain::engineering
                             ? 1
                             : length * (first * first + s * second) - s * first;
    const Matrix3 block = w * (s * first / length * Matrix3::Identity() +
                               along * d * d.transpose() / (length * length * length));
    for (int L = 0; L < 3; ++L)
      for (int J = 0; J < 3; ++J) A.block<3, 3>(3 * J, 3 * L) += n[J] * n[L] * block;
  }
  if (strain == SpringStrain::green) {
    const Matrix3 F = Matrix3::Identity() + displacement_gradient;
    A -= springs_bulk_modulus() * F.reshaped() * F.reshaped().transpose();
  }
  return A;
}

Dilatation CauchyBorn::dilatation(const Matrix3& displacement_gradient) const {
  return strain == SpringStrain::green ? green_strain_trace(displacement_gradient)
                                       : volume_change(displacement_gradient);
}

VolumetricEnergy CauchyBorn::volumetric_energy(double dilatation) const {
  if (strain == SpringStrain::hencky) {
    const bool is_whole = stretch == SpringStretch::whole;
    const auto square = logarithmic(
                   volume_modulus + (is_whole ? 0 : springs_bulk_modulus()), dilatation),
               cube = cubic_logarithmic(cubic_modulus, dilatation);
    return {.value = square.value + cube.value,
            .first = square.first + cube.first,
            .second = square.second + cube.second};
  }
  return strain == SpringStrain::logarithmic
             ? logarithmic(volume_modulus, dilatation)
             : quadratic(strain == SpringStrain::green
                             ? volume_modulus + springs_bulk_modulus()
                             : volume_modulus,
                         dilatation);
}

CauchyBorn cauchy_born(const Material& material, const Lattice& lattice) {
  const auto [lambda, mu] = lame_constants(material);
  const double spring_mu = lattice.constants == SpringConstants::from_young_modulus
                               ? 0.4 * material.young_modulus
                               : mu;
  CauchyBorn law{.springs = {}, .volume_modulus = lambda - mu, .strain = lattice.strain};
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
      law.springs = virtual_springs(spring_mu, lattice.axes);
      break;
  }
  if (lattice.springs == Springs::affine)
    law.stretch = SpringStretch::isochoric;
  else if (lattice.strain == SpringStrain::hencky && lattice.springs != Springs::fd &&
           lattice.springs != Springs::baudet)
    law.cubic_modulus = law.springs_bulk_modulus() * 9 / 15;
  const Matrix3 turn = lattice_to_body(lattice.direction);
  for (SpringDirection& spring : law.springs) spring.direction = turn * spring.direction;
  return law;
}

}  // namespace springcheck::fem_reference
