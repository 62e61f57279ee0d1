#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

// Uniaxial stress in a homogeneous body: sliding plates stretch it by L along z, its
// sides are free. Written down from the laws' definitions, apart from the code they
// check.
namespace homogeneous {

/// The state at a stretch L along z.
struct Uniaxial {
  double stress;                  // nominal: force per undeformed area [Pa]
  std::array<double, 2> lateral;  // stretches along x and y
  double volume_ratio;            // J, deformed over undeformed
};

inline Uniaxial state(double stretch, double lateral, double stress) {
  return {stress, {lateral, lateral}, stretch * lateral * lateral};
}

/// Hooke's law with the small strain e = L - 1: stress E e, lateral strain -nu e.
inline Uniaxial hooke(double young_modulus, double nu, double stretch) {
  const double strain = stretch - 1;
  return state(stretch, 1 - nu * strain, young_modulus * strain);
}

/// St-Venant-Kirchhoff is Hooke's law between the second Piola-Kirchhoff stress S and the
/// Green-Lagrange strain: S = E (L^2 - 1)/2, l^2 - 1 = -nu (L^2 - 1), P = L S.
inline Uniaxial st_venant_kirchhoff(double young_modulus, double nu, double stretch) {
  const double twice_strain = stretch * stretch - 1;
  return state(stretch, std::sqrt(1 - nu * twice_strain),
               young_modulus / 2 * stretch * twice_strain);
}

/// Hencky, psi = mu |dev ln V|^2 + K/2 (ln J)^2, is Hooke's law between the Kirchhoff
/// stress and the logarithmic strain: tau = E ln L, ln l = -nu ln L, P = tau/L.
inline Uniaxial hencky(double young_modulus, double nu, double stretch) {
  return state(stretch, std::pow(stretch, -nu),
               young_modulus * std::log(stretch) / stretch);
}

/// Springs along one direction: w/2 (|F n| - 1)^2 per undeformed volume.
struct SpringDirection {
  Eigen::Vector3d n;  // unit vector
  double w;           // k r^2/h^3 [Pa]: one spring k [N/m] of length r in each cell h^3
};

/// Continuum of a lattice of springs:
///
///     psi(F) = sum w/2 (|F n| - 1)^2 + kappa/2 (det F - 1)^2
struct Lattice {
  std::vector<SpringDirection> directions;
  double kappa;  // [Pa]
};

/// Springs of a cubic lattice of edge h, each counted once a cell [N/m] over h: k/h [Pa].
struct CubicSprings {
  double edge, face_diagonal, inner_diagonal;
};

/// 3 edges (r = h), 6 face diagonals (r^2 = 2 h^2), 4 inner diagonals (r^2 = 3 h^2).
inline Lattice cubic_lattice(const CubicSprings& k, double kappa) {
  Lattice lattice{.directions = {}, .kappa = kappa};
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        if (9 * x + 3 * y + z <= 0) continue;  // of r and -r, one
        const Eigen::Vector3d r(x, y, z);
        const int kind = x * x + y * y + z * z;
        const double stiffness = kind == 1   ? k.edge
                                 : kind == 2 ? k.face_diagonal
                                             : k.inner_diagonal;
        lattice.directions.push_back({r.normalized(), stiffness * kind});
      }
  return lattice;
}

struct Moduli {
  double mu, lambda;  // [Pa]
};
inline Moduli moduli(double young_modulus, double nu) {
  return {young_modulus / (2 * (1 + nu)), young_modulus * nu / ((1 + nu) * (1 - 2 * nu))};
}

/// Golec 2018, section 5.2, in the form that holds for every nu: k_c = 3 mu h/(3A + 4),
/// k_f = A k_c, k_e = k_f + 8/3 k_c.
inline CubicSprings golec_springs(double mu, double diagonal_ratio) {
  const double inner = 3 * mu / (3 * diagonal_ratio + 4), face = diagonal_ratio * inner;
  return {.edge = face + 8 * inner / 3, .face_diagonal = face, .inner_diagonal = inner};
}

/// The lattice of mss-cf (mss-nfd: A = 0), with the volume correction kappa = lambda -
/// mu.
inline Lattice cf_lattice(double young_modulus, double nu, double diagonal_ratio) {
  const auto [mu, lambda] = moduli(young_modulus, nu);
  return cubic_lattice(golec_springs(mu, diagonal_ratio), lambda - mu);
}

/// The lattice of mss-cf with springs from E as the thesis prints them (5.12), mu
/// replaced by its value at nu = 1/4, and the right kappa.
inline Lattice young_form_lattice(double young_modulus, double nu,
                                  double diagonal_ratio) {
  const auto [mu, lambda] = moduli(young_modulus, nu);
  return cubic_lattice(golec_springs(0.4 * young_modulus, diagonal_ratio), lambda - mu);
}

/// The lattice of mss-fd: the springs of mss-cf without a correction.
inline Lattice fd_lattice(double young_modulus, double nu, double diagonal_ratio) {
  return cubic_lattice(golec_springs(moduli(young_modulus, nu).mu, diagonal_ratio), 0);
}

/// The lattice of mss-baudet: per cell k_ed = E h (4 nu + 1)/(8 (1 + nu)) on edges, of
/// which four cells share one, and 3 E h/(8 (1 + nu)) on inner diagonals; no correction.
inline Lattice baudet_lattice(double young_modulus, double nu) {
  return cubic_lattice({.edge = young_modulus * (4 * nu + 1) / (2 * (1 + nu)),
                        .face_diagonal = 0,
                        .inner_diagonal = 3 * young_modulus / (8 * (1 + nu))},
                       0);
}

/// The lattice of mss-affine: 5 mu/4 sum (|F n| - 1)^2 over the six axes of an
/// icosahedron.
inline Lattice affine_lattice(double young_modulus, double nu) {
  const auto [mu, lambda] = moduli(young_modulus, nu);
  Lattice lattice{.directions = {}, .kappa = lambda - mu};
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1., 1.}) {
      Eigen::Vector3d n = Eigen::Vector3d::Zero();
      n[(axis + 1) % 3] = sign;
      n[(axis + 2) % 3] = std::numbers::phi;
      lattice.directions.push_back({n.normalized(), 5 * mu / 2});
    }
  return lattice;
}

/// The lattice with its direction `along_z` turned to z, and the direction `along_x`, at
/// right angles to it, to x.
inline Lattice turned(Lattice lattice, const Eigen::Vector3d& along_z,
                      const Eigen::Vector3d& along_x) {
  Eigen::Matrix3d axes;
  axes.row(0) = along_x.normalized();
  axes.row(2) = along_z.normalized();
  axes.row(1) = axes.row(2).cross(axes.row(0));
  for (SpringDirection& direction : lattice.directions) direction.n = axes * direction.n;
  return lattice;
}

// Two other directions of a cubic lattice. The lateral axes are those in which F stays
// diagonal: normals of mirror planes (100, 110), or any (111, a threefold axis).
inline Lattice along_110(const Lattice& lattice) {
  return turned(lattice, {1, 1, 0}, {0, 0, 1});
}
inline Lattice along_111(const Lattice& lattice) {
  return turned(lattice, {1, 1, 1}, {1, -1, 0});
}

/// psi at F = diag(x) and its derivatives.
struct Energy {
  double value;
  Eigen::Vector3d gradient;
  Eigen::Matrix3d hessian;
};

inline Energy energy(const Lattice& lattice, const Eigen::Vector3d& x) {
  Energy psi{.value = 0,
             .gradient = Eigen::Vector3d::Zero(),
             .hessian = Eigen::Matrix3d::Zero()};
  for (const auto& [n, w] : lattice.directions) {
    const Eigen::Vector3d square = n.cwiseProduct(n);
    const double length = n.cwiseProduct(x).norm();  // |F n|
    const Eigen::Vector3d d_length = square.cwiseProduct(x) / length;
    const Eigen::Matrix3d d2_length =
        (Eigen::Matrix3d(square.asDiagonal()) - d_length * d_length.transpose()) / length;
    psi.value += w / 2 * (length - 1) * (length - 1);
    psi.gradient += w * (length - 1) * d_length;
    psi.hessian += w * (d_length * d_length.transpose() + (length - 1) * d2_length);
  }
  const double det = x.prod();
  const Eigen::Vector3d d_det(x[1] * x[2], x[2] * x[0], x[0] * x[1]);
  Eigen::Matrix3d d2_det;
  d2_det << 0, x[2], x[1], x[2], 0, x[0], x[1], x[0], 0;
  psi.value += lattice.kappa / 2 * (det - 1) * (det - 1);
  psi.gradient += lattice.kappa * (det - 1) * d_det;
  psi.hessian += lattice.kappa * (d_det * d_det.transpose() + (det - 1) * d2_det);
  return psi;
}

/// The lattice under uniaxial stress: the lateral stretches minimise psi (Newton), the
/// stress is dpsi/dL. Throws std::runtime_error where it finds no minimum.
inline Uniaxial uniaxial(const Lattice& lattice, double stretch) {
  Eigen::Vector3d x(1, 1, stretch);
  x.head<2>().setConstant(std::sqrt(1 / stretch));  // keeps det F = 1
  for (int iteration = 0; iteration < 50; ++iteration) {
    const Energy psi = energy(lattice, x);
    const Eigen::LLT<Eigen::Matrix2d> across(psi.hessian.topLeftCorner<2, 2>());
    const Eigen::Vector2d step = -across.solve(psi.gradient.head<2>());
    if (across.info() != Eigen::Success) break;  // not positive definite
    x.head<2>() += step;
    if (step.norm() < 1e-14)
      return {energy(lattice, x).gradient[2], {x[0], x[1]}, x.prod()};
  }
  throw std::runtime_error("no minimum across the stretch");
}

}  // namespace homogeneous
