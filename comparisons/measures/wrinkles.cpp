#include "comparisons/measures/wrinkles.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace springcheck {
namespace {

using Vector2 = Eigen::Vector2d;
using Matrix2 = Eigen::Matrix2d;

/// Boundary faces that look the same way, to the nearest axis.
struct Side {
  std::array<Eigen::Index, 2> plane;  // the other axes
  std::set<std::pair<NodeIndex, NodeIndex>> edges;
};
using Sides = std::array<Side, 6>;

constexpr double amplitude_rounding = 1e-7;

/// What an affine fit of its neighbours' displacements says of a node.
struct FittedNode {
  Vector3 residual;      // r [m]
  double square_strain;  // |E|^2
};

std::size_t side_of(const Mesh& mesh, const FaceNodes& face) {
  const auto& x = mesh.nodes();
  const Vector3 normal = (x[face[2]] - x[face[0]])
                             .cross(x[face.size() == 4 ? face[3] : face[0]] - x[face[1]]);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return 2 * static_cast<std::size_t>(axis) + (normal[axis] > 0 ? 1 : 0);
}

/// Nodes that plates or the boundary gradient hold, and those on more than one side.
std::vector<bool> nodes_left_out(const Mesh& mesh, const Scene& scene) {
  std::vector<bool> left_out(mesh.nodes().size(), scene.boundary_gradient.has_value());
  for (const Plate& plate : scene.plates)
    for (const NodeIndex n : mesh.region(plate.region).nodes) left_out[n] = true;
  std::map<NodeIndex, std::size_t> first;
  for (const FaceNodes& face : mesh.boundary().faces)
    for (const NodeIndex n : face) {
      const std::size_t side = side_of(mesh, face);
      if (first.emplace(n, side).first->second != side) left_out[n] = true;
    }
  return left_out;
}

Sides sides_of(const Mesh& mesh) {
  Sides sides;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const auto axis = static_cast<Eigen::Index>(s / 2);
    sides[s].plane = {(axis + 1) % 3, (axis + 2) % 3};
  }
  for (const FaceNodes& face : mesh.boundary().faces)
    for (std::size_t i = 0; i < face.size(); ++i)
      sides[side_of(mesh, face)].edges.insert(
          std::minmax(face[i], face[(i + 1) % face.size()]));
  return sides;
}

/// What the neighbours tell of a node, by an affine fit; none where they lie on a line.
std::optional<FittedNode> fit_at(const Mesh& mesh, const Side& side, NodeIndex node,
                                 const std::vector<NodeIndex>& neighbours,
                                 std::span<const Vector3> displacements) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero(), right = Eigen::Matrix3d::Zero();
  double square = 0;  // of the neighbours' distances
  for (const NodeIndex n : neighbours)
    square += (mesh.nodes()[n] - mesh.nodes()[node]).squaredNorm();
  const double scale = std::sqrt(square / static_cast<double>(neighbours.size()));
  for (const NodeIndex n : neighbours) {
    const Vector3 d = (mesh.nodes()[n] - mesh.nodes()[node]) / scale;
    const Vector3 monomials(1, d[side.plane[0]], d[side.plane[1]]);
    normal += monomials * monomials.transpose();
    right += monomials * (displacements[n] - displacements[node]).transpose();
  }
  Eigen::FullPivLU<Eigen::Matrix3d> factors(normal);
  factors.setThreshold(1e-9);
  if (!factors.isInvertible()) return std::nullopt;
  const Eigen::Matrix3d fit = factors.solve(right);
  const Eigen::Matrix<double, 3, 2> H = fit.bottomRows<2>().transpose() / scale;
  Matrix2 strain = H.transpose() * H;
  for (Eigen::Index i = 0; i < 2; ++i)
    for (Eigen::Index j = 0; j < 2; ++j)
      strain(i, j) += H(side.plane[static_cast<std::size_t>(i)], j) +
                      H(side.plane[static_cast<std::size_t>(j)], i);
  return FittedNode{.residual = -fit.row(0).transpose(),
                    .square_strain = strain.squaredNorm() / 4};
}

/// What is seen at the side's nodes that are not left out.
std::map<NodeIndex, FittedNode> fit_all(const Mesh& mesh, const Side& side,
                                        const std::vector<bool>& left_out,
                                        std::span<const Vector3> displacements) {
  std::map<NodeIndex, std::vector<NodeIndex>> neighbours;
  for (const auto& [a, b] : side.edges) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  std::map<NodeIndex, FittedNode> all;
  for (const auto& [node, near] : neighbours)
    if (!left_out[node])
      if (const auto fitted = fit_at(mesh, side, node, near, displacements))
        all.emplace(node, *fitted);
  return all;
}

/// The wrinkling of a side, with amplitude rms r / h: the strain is known when all sides
/// are.
Wrinkling zigzag(const Mesh& mesh, const Side& side,
                 const std::map<NodeIndex, FittedNode>& fitted) {
  Matrix2 products = Matrix2::Zero(), squares = Matrix2::Zero();  // C and S
  double square_edges = 0, edges = 0, square_residuals = 0;
  for (const auto& [a, b] : side.edges) {
    const auto at_a = fitted.find(a), at_b = fitted.find(b);
    if (at_a == fitted.end() && at_b == fitted.end()) continue;
    const Vector3 zero = Vector3::Zero();
    const Vector3 r_a = at_a == fitted.end() ? zero : at_a->second.residual;
    const Vector3 r_b = at_b == fitted.end() ? zero : at_b->second.residual;
    const Vector3 edge = mesh.nodes()[b] - mesh.nodes()[a];
    const Vector2 t = Vector2(edge[side.plane[0]], edge[side.plane[1]]).normalized();
    products += r_a.dot(r_b) * t * t.transpose();
    squares += (r_a.squaredNorm() + r_b.squaredNorm()) / 2 * t * t.transpose();
    square_edges += edge.squaredNorm();
    ++edges;
  }
  for (const auto& [node, at] : fitted) square_residuals += at.residual.squaredNorm();
  Wrinkling seen{
      .alternation = -1,
      .amplitude = std::sqrt(square_residuals / static_cast<double>(fitted.size()) /
                             (square_edges / edges))};
  if (squares.determinant() > 0)
    seen.alternation = -Eigen::GeneralizedSelfAdjointEigenSolver<Matrix2>(
                            products, squares, Eigen::EigenvaluesOnly)
                            .eigenvalues()[0];
  return seen;
}

}  // namespace

std::optional<Wrinkling> measure_wrinkling(const Mesh& mesh, const Scene& scene,
                                           std::span<const Vector3> displacements) {
  const std::vector<bool> left_out = nodes_left_out(mesh, scene);
  std::vector<Wrinkling> seen;
  double square_strains = 0, nodes = 0;
  for (const Side& side : sides_of(mesh)) {
    const auto fitted = fit_all(mesh, side, left_out, displacements);
    if (fitted.empty()) continue;
    seen.push_back(zigzag(mesh, side, fitted));
    for (const auto& [node, at] : fitted) {
      square_strains += at.square_strain;
      ++nodes;
    }
  }
  if (seen.empty()) return std::nullopt;
  const double strain = std::sqrt(square_strains / nodes);
  for (Wrinkling& side : seen) {
    side.amplitude = strain > 0 ? side.amplitude / strain : 0;
    if (side.amplitude < amplitude_rounding) side.alternation.reset();
  }
  return *std::ranges::max_element(seen, {}, [](const Wrinkling& side) {
    return std::pair(is_wrinkled(side), side.alternation);
  });
}

bool is_wrinkled(const Wrinkling& wrinkling) {
  constexpr double rounding = 1e-6;  // two nodes in a line may alternate by 1/2
  return wrinkling.alternation > *wrinkled_above.alternation + rounding &&
         wrinkling.amplitude > wrinkled_above.amplitude;
}

}  // namespace springcheck
