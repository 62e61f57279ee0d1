#pragma once

#include <span>
#include <vector>

#include "mss/networks/network.hpp"

namespace springcheck::mss {

/// The part of the tangent that a star has: its matrix is
///
///     D^T shape D + volume v v^T,   (D u)_iJ = sum u_a,i G_a,J,   v u = sum u_a . g_a
///
/// over its nodes a; never put together for longer than it takes to add it somewhere.
struct StarTangent {
  std::vector<NodeIndex> nodes;         // of all its cells, ascending
  Eigen::Matrix3Xd gradients{};         // G_a of the star's mean F [1/m]
  Matrix9 shape;                        // 3/4 V_n dP/dF [J]
  Eigen::Matrix3Xd volume_gradients{};  // g_a of its mean volume change [1/m]
  double volume;                        // V_n U''(t_n) [J]
};
Eigen::MatrixXd matrix(const StarTangent& star);

/// Second derivative of the energy [N/m] as a sum of patches, each over a few nodes. 3x3
/// blocks in the order of the patch's nodes.
struct Tangent {
  // Of each cell's own energy, with its springs' and with the pressure of its nodes'
  // stars:
  std::vector<Eigen::MatrixXd> cells;
  std::vector<StarTangent> stars;  // of each node; none without stars
};

/// Adds to a patch's matrix what a spring between two of its nodes has, a matrix of its
/// pull on the one by the other's way.
void add_between(Eigen::MatrixXd& tangent, const LocalEdge& ends, const Matrix3& block);

/// Per spring of constant rest length T/|d| (I - n n^T) + dT/d|d| n n^T between its two
/// nodes, per spring of affine rest length the like through its elongation, and from the
/// law V D^T (dP/dF) D. In parallel.
Tangent tangent_at(const Network& network, std::span<const Vector3> positions);

/// Sets the negative eigenvalues of every cell's matrix, and of both parts of every star,
/// to zero, in parallel. Assembled, such patches give a descent direction even where the
/// true tangent is indefinite.
void clamp_to_positive(Tangent& tangent);

/// The tangent times one vector per node, patch by patch.
std::vector<Vector3> product(const Network& network, const Tangent& tangent,
                             std::span<const Vector3> vectors);

/// Nodes of the tangent's patches: cells first, then stars.
std::vector<std::vector<NodeIndex>> patches(const Network& network);

/// The matrix of one of them.
Eigen::MatrixXd part(const Tangent& tangent, std::size_t patch);

}  // namespace springcheck::mss
