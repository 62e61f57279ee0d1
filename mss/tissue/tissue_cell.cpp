#include "mss/tissue/tissue_cell.hpp"

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "meshing/mesh.hpp"
#include "mss/cell_springs.hpp"

namespace springcheck::mss {
namespace {

using Eigen::Index;
using tissue::SymmetricTensor;

/// A spring between nodes a and b: w, and t as a row times the six entries of S.
struct TissueSpring {
  Index a, b;
  double weight;
  SymmetricTensor tension;
};

/// Corner i of the unit cube.
Vector3 corner(Index i) {
  constexpr std::array<std::array<double, 3>, 8> places{{{0, 0, 0},
                                                         {1, 0, 0},
                                                         {1, 1, 0},
                                                         {0, 1, 0},
                                                         {0, 0, 1},
                                                         {1, 0, 1},
                                                         {1, 1, 1},
                                                         {0, 1, 1}}};
  const auto& [x, y, z] = places[static_cast<std::size_t>(i)];
  return {x, y, z};
}

std::vector<TissueSpring> make_springs() {
  constexpr double edge_share = 11. / 35, diagonal_share = 3. / 35;
  const SymmetricTensor mean{1. / 3, 1. / 3, 1. / 3, 0, 0, 0};
  std::vector<TissueSpring> springs;
  const auto add = [&](const LocalEdge& ends, double weight,
                       const SymmetricTensor& tension) {
    springs.push_back(
        {static_cast<Index>(ends[0]), static_cast<Index>(ends[1]), weight, tension});
  };
  for (const LocalEdge& ends : edges(CellType::hexahedron)) {
    const auto along = static_cast<Index>(edge_direction(ends));
    add(ends, 0.25, (edge_share - 1) * mean + SymmetricTensor::Unit(along));
  }
  for (const LocalEdge& ends : face_diagonals(CellType::hexahedron)) {
    // S_jk of the axes j, k of the face follows the diagonal entries, by the axis across.
    const auto across = static_cast<Index>(face_direction(ends));
    const Vector3 r =
        corner(static_cast<Index>(ends[1])) - corner(static_cast<Index>(ends[0]));
    const double sign = r[(across + 1) % 3] * r[(across + 2) % 3];
    add(ends, 0.5, diagonal_share * mean + sign / 2 * SymmetricTensor::Unit(3 + across));
  }
  for (const LocalEdge& ends : inner_diagonals(CellType::hexahedron))
    add(ends, 1, diagonal_share * mean);
  return springs;
}

const std::vector<TissueSpring>& springs() {
  static const std::vector<TissueSpring> all = make_springs();
  return all;
}

/// 4 h G_a of all nodes, as columns.
const HexahedronPositions& signs() {
  static const HexahedronPositions all = [] {
    HexahedronPositions s;
    for (Index a = 0; a < 8; ++a) s.col(a) = 2 * corner(a) - Vector3::Ones();
    return s;
  }();
  return all;
}

Matrix3 cofactor_of(const Matrix3& F) {
  Matrix3 cofactor;
  cofactor << F.col(1).cross(F.col(2)), F.col(2).cross(F.col(0)),
      F.col(0).cross(F.col(1));
  return cofactor;
}

/// dC/dx: the entries of C by the positions.
Eigen::Matrix<double, 6, 24> strain_operator(const Matrix3& F, double edge) {
  constexpr std::array<std::array<int, 2>, 6> places{
      {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
  const HexahedronPositions G = signs() / (4 * edge);
  Eigen::Matrix<double, 6, 24> B;
  for (Index a = 0; a < 8; ++a)
    for (Index entry = 0; entry < 6; ++entry) {
      const auto [j, k] = places[static_cast<std::size_t>(entry)];
      B.block<1, 3>(entry, 3 * a) = (G(j, a) * F.col(k) + G(k, a) * F.col(j)).transpose();
    }
  return B;
}

}  // namespace

Matrix3 mean_deformation_gradient(const HexahedronPositions& x, double edge) {
  return x * signs().transpose() / (4 * edge);
}

SymmetricTensor right_cauchy_green(const HexahedronPositions& x, double edge) {
  const Matrix3 F = mean_deformation_gradient(x, edge);
  return tissue::symmetric_tensor(F.transpose() * F);
}

SymmetricTensor right_cauchy_green_rate(const HexahedronPositions& x,
                                        const HexahedronPositions& v, double edge) {
  const Matrix3 half =
      mean_deformation_gradient(x, edge).transpose() * mean_deformation_gradient(v, edge);
  return tissue::symmetric_tensor(half + half.transpose());
}

HexahedronPositions tissue_forces(const HexahedronPositions& x, double edge,
                                  const tissue::PointStress& stress) {
  const Matrix3 F = mean_deformation_gradient(x, edge);
  HexahedronPositions forces =
      -edge * edge / 4 * stress.volume * cofactor_of(F) * signs();
  for (const TissueSpring& spring : springs()) {
    const Vector3 pull = spring.weight * edge * spring.tension.dot(stress.strands) *
                         (x.col(spring.b) - x.col(spring.a));
    forces.col(spring.a) += pull;
    forces.col(spring.b) -= pull;
  }
  return forces;
}

Matrix24 tissue_stiffness(const HexahedronPositions& x, double edge,
                          const tissue::PointStress& stress,
                          const tissue::PointTangent& tangent) {
  const Matrix3 F = mean_deformation_gradient(x, edge);
  Matrix24 K = Matrix24::Zero();

  // Springs: at their tensions, and by the change of those.
  Eigen::Matrix<double, 24, 6> by_strands = Eigen::Matrix<double, 24, 6>::Zero();
  for (const auto& [a, b, weight, tension] : springs()) {
    const double stiffness = weight * edge * tension.dot(stress.strands);
    for (Index i = 0; i < 3; ++i) {
      K(3 * a + i, 3 * a + i) += stiffness;
      K(3 * b + i, 3 * b + i) += stiffness;
      K(3 * a + i, 3 * b + i) -= stiffness;
      K(3 * b + i, 3 * a + i) -= stiffness;
    }
    const Eigen::Matrix<double, 3, 6> change =
        weight * edge * (x.col(b) - x.col(a)) * tension.transpose();
    by_strands.middleRows<3>(3 * b) += change;
    by_strands.middleRows<3>(3 * a) -= change;
  }

  // Volume force h^3 v cof F G_a: at its v, and by the change of that.
  const double scale = edge * edge * edge;
  const HexahedronPositions G = signs() / (4 * edge);
  for (Index a = 0; a < 8; ++a)
    for (Index b = 0; b < 8; ++b) {
      const Vector3 w = scale * stress.volume * F * G.col(a).cross(G.col(b));
      K.block<3, 3>(3 * a, 3 * b) +=
          (Matrix3() << 0, w.z(), -w.y(), -w.z(), 0, w.x(), w.y(), -w.x(), 0).finished();
    }
  const HexahedronPositions by_volume = scale * cofactor_of(F) * G;
  const Eigen::Map<const Eigen::Matrix<double, 24, 1>> by_volume_of(by_volume.data());

  K += (by_strands * tangent.strands + by_volume_of * tangent.volume.transpose()) *
       strain_operator(F, edge);
  return K;
}

}  // namespace springcheck::mss
