#pragma once

#include <span>
#include <vector>

#include "mss/forces/cell_forces.hpp"

namespace springcheck::mss {

/// Second derivative of the energy [N/m] at a state, as a sum of patches, each over a few
/// nodes. Refers to the network; a patch's matrix is computed when it is asked for.
struct Tangent {
  const Network* network;
  std::vector<Vector3> positions;  // [m]
  CellStates states;
};

/// Adds to a patch's matrix what a spring between two of its nodes has, a matrix of its
/// pull on the one by the other's way.
void add_between(Eigen::MatrixXd& tangent, const LocalEdge& ends, const Matrix3& block);

Tangent tangent_at(const Network& network, std::span<const Vector3> positions);

/// Nodes of the tangent's patches: cells first, then the nodal patches of each node,
/// those of all cells of the nodal patch, ascending.
std::vector<std::vector<NodeIndex>> patches(const Network& network);

/// The matrix of one of them, in 3x3 blocks in the order of the patch's nodes. A cell has
/// that of its own energy, its springs' and what the pressure of its nodes' patches does:
/// per spring of constant rest length T/|d| (I - n n^T) + dT/d|d| n n^T between its two
/// nodes, per spring of affine rest length the like through its elongation, and from the
/// law V D^T (dP/dF) D. A nodal patch has
///
///     3/4 V_n D^T (dP/dF) D + V_n U''(t_n) v v^T
///     (D u)_iJ = sum u_a,i G_a,J   of its mean F,   v u = sum u_a . g_a   of t_n
Eigen::MatrixXd part(const Tangent& tangent, std::size_t patch);

/// The like with negative eigenvalues set to zero: of a cell's matrix, of a nodal patch's
/// dP/dF and U''. Assembled, such patches give a descent direction even where the true
/// tangent is indefinite.
Eigen::MatrixXd positive_part(const Tangent& tangent, std::size_t patch);

/// The tangent times one vector per node, patch by patch.
std::vector<Vector3> product(const Tangent& tangent, std::span<const Vector3> vectors);

}  // namespace springcheck::mss
