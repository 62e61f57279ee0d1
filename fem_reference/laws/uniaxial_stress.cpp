#include "fem_reference/laws/uniaxial_stress.hpp"

#include <fmt/format.h>

#include <Eigen/LU>

#include "meshing/basics/breakdown.hpp"

namespace springcheck::fem_reference {

Matrix3 uniaxial_stress_state(const CauchyBorn& law, double strain) {
  constexpr int most_iterations = 50;
  constexpr double tolerance = 1e-10;  // change of the lateral strains, the last of which
                                       // Newton's method squares
  Matrix3 H = Matrix3::Zero();
  H(2, 2) = strain;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Dilatation t = law.dilatation(H);
    const VolumetricEnergy U = law.volumetric_energy(t.value);
    const Matrix3 P = law.stress(H) + U.first * t.first;
    const Vector9 gradient = t.first.reshaped();
    const Matrix9 tangent =
        law.tangent(H) + U.second * gradient * gradient.transpose() + U.first * t.second;
    // Entries xx and yy of a matrix are 0 and 4 of its column.
    Eigen::Matrix2d lateral;
    lateral << tangent(0, 0), tangent(0, 4), tangent(4, 0), tangent(4, 4);
    const Eigen::Vector2d change =
        -lateral.partialPivLu().solve(Eigen::Vector2d(P(0, 0), P(1, 1)));
    if (!change.allFinite()) break;
    H(0, 0) += change[0];
    H(1, 1) += change[1];
    if (change.norm() < tolerance) return H;
  }
  throw Breakdown(
      fmt::format("no state of uniaxial stress found at a strain of {}", strain));
}

}  // namespace springcheck::fem_reference
