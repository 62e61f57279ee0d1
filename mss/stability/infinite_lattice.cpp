#include "mss/stability/infinite_lattice.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "mss/forces/tangent.hpp"

namespace springcheck::mss {
namespace {

using std::numbers::pi;

constexpr int grid_points = 6;  // from the zone's centre to its boundary
constexpr int descents = 12;    // from so many of the grid's lowest points
constexpr double first_stride = pi / (2 * grid_points);  // [rad per cell]
constexpr double last_stride = 1e-5;
constexpr int most_moves = 100;  // more only creep down a valley towards long waves

std::size_t index(const Eigen::Vector3i& n) {
  return static_cast<std::size_t>(9 * (n.z() + 1) + 3 * (n.y() + 1) + n.x() + 1);
}

template <class Visit>
void for_each_neighbour(const Visit& visit) {
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) visit(Eigen::Vector3i(x, y, z));
}

template <class Matrix>
double lowest_eigenvalue(const Matrix& matrix) {
  return Eigen::SelfAdjointEigenSolver<Matrix>(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues()[0];
}

bool is_long(const Vector3& phases) {
  return phases.norm() < long_wave;
}

Vector3 as_long_wave(const Vector3& direction) {
  return long_wave / 2 * direction.normalized();
}

LatticeWave wave(const Couplings& lattice, const Vector3& phases) {
  return {.phases = phases, .modulus = wave_modulus(lattice, phases)};
}

Vector3 in_zone(Vector3 phases) {
  for (double& t : phases) t -= 2 * pi * std::ceil((t - pi) / (2 * pi));
  return phases;
}

/// The wave that a descent leads to, by steps along the axes that shrink where none leads
/// down. A long wave stays one, and its direction is varied.
LatticeWave descended(const Couplings& lattice, LatticeWave from) {
  const bool stays_long = is_long(from.phases);
  if (stays_long) from.phases.normalize();
  // A gain of nothing but rounding would go on for ever.
  const double gain = 1e-13 * largest_modulus(lattice);
  int moves = 0;
  for (double stride = first_stride; stride > last_stride; stride /= 2)
    for (bool moved = true; moved && moves < most_moves;) {
      moved = false;
      for (int i = 0; i < 6; ++i) {
        Vector3 phases = from.phases;
        phases[i / 2] += i % 2 == 0 ? stride : -stride;
        if (stays_long) phases.normalize();
        if (!stays_long && is_long(phases)) continue;  // there may be no direction left
        const double modulus =
            wave_modulus(lattice, stays_long ? as_long_wave(phases) : phases);
        if (modulus < from.modulus - gain) {
          from = {.phases = phases, .modulus = modulus};
          moved = true;
          ++moves;
        }
      }
    }
  from.phases = stays_long ? as_long_wave(from.phases) : in_zone(from.phases);
  return from;
}

/// The softest wave that descents from the lowest of `waves` lead to; there must be at
/// least `descents` of them.
LatticeWave softest_below(const Couplings& lattice, std::vector<LatticeWave> waves) {
  std::ranges::partial_sort(waves, waves.begin() + descents, {}, &LatticeWave::modulus);
  waves.resize(descents);
  for (LatticeWave& wave : waves) wave = descended(lattice, wave);
  return *std::ranges::min_element(waves, {}, &LatticeWave::modulus);
}

}  // namespace

Couplings couplings(const Network& cell, const Matrix3& deformation_gradient) {
  assert(cell.volume_patches.size() == 0 && cell.shape_patches.size() == 0);
  std::vector<Vector3> positions;
  for (const Vector3& X : cell.rest_positions)
    positions.push_back(deformation_gradient * X);
  const Eigen::MatrixXd K = part(tangent_at(cell, positions), 0);
  Couplings lattice{.edge = std::cbrt(cell.cells.volume(0))};
  lattice.blocks.fill(Matrix3::Zero());
  const auto nodes = cell.cells.nodes(0);
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (std::size_t b = 0; b < nodes.size(); ++b) {
      const Vector3 offset =
          (cell.rest_positions[nodes[b]] - cell.rest_positions[nodes[a]]) / lattice.edge;
      lattice.blocks[index(offset.array().round().cast<int>())] += K.block<3, 3>(
          static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b));
    }
  return lattice;
}

Matrix3c dynamical_matrix(const Couplings& lattice, const Vector3& phases) {
  const std::complex<double> one = 1, x = std::polar(1., phases.x()),
                             y = std::polar(1., phases.y()),
                             z = std::polar(1., phases.z());
  const std::complex<double> along[3][3] = {
      {conj(x), one, x}, {conj(y), one, y}, {conj(z), one, z}};
  Matrix3c D = Matrix3c::Zero();
  for_each_neighbour([&](const Eigen::Vector3i& n) {
    D += along[0][n.x() + 1] * along[1][n.y() + 1] * along[2][n.z() + 1] *
         lattice.blocks[index(n)];
  });
  return D;
}

Matrix3 acoustic_tensor(const Couplings& lattice, const Vector3& direction) {
  Matrix3 Q = Matrix3::Zero();
  for_each_neighbour([&](const Eigen::Vector3i& n) {
    const double along = direction.dot(n.cast<double>());
    Q -= along * along / (2 * lattice.edge) * lattice.blocks[index(n)];
  });
  return Q;
}

double largest_modulus(const Couplings& lattice) {
  return lattice.blocks[index(Eigen::Vector3i::Zero())].norm() / lattice.edge;
}

double wave_modulus(const Couplings& lattice, const Vector3& phases) {
  if (is_long(phases))
    return lowest_eigenvalue(acoustic_tensor(lattice, phases.normalized()));
  const double squares = (phases / 2).array().sin().square().sum();
  return lowest_eigenvalue(dynamical_matrix(lattice, phases)) /
         (4 * lattice.edge * squares);
}

LatticeWave softest_wave(const Couplings& lattice) {
  std::vector<LatticeWave> waves, long_waves;
  const int end = grid_points;
  for (int z = 0; z <= end; ++z)  // the other half of the zone has the conjugates
    for (int y = -end; y <= end; ++y)
      for (int x = -end; x <= end; ++x) {
        const Eigen::Vector3i point(x, y, z);
        if (point.isZero()) continue;
        const Vector3 phases = pi / grid_points * point.cast<double>();
        waves.push_back(wave(lattice, phases));
        if (point.cwiseAbs().maxCoeff() == end)
          long_waves.push_back(wave(lattice, as_long_wave(phases)));
      }
  const LatticeWave longest = softest_below(lattice, std::move(long_waves)),
                    softest = softest_below(lattice, std::move(waves));
  const bool is_lower =
      softest.modulus < longest.modulus - 1e-9 * largest_modulus(lattice);
  return is_lower ? softest : longest;
}

double wavelength(const LatticeWave& wave) {
  return is_long(wave.phases) ? std::numeric_limits<double>::infinity()
                              : 2 * pi / wave.phases.norm();
}

}  // namespace springcheck::mss
