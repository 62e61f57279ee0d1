#pragma once

#include <Eigen/Core>
#include <vector>

#include "fem_reference/cells/discretisation.hpp"

namespace springcheck::fem_reference {

/// Linear elements whose law is averaged around the nodes, q1_nodal. With the shape part
/// psi of a law and its volumetric part U(t),
///
///     W = sum over other cells than tetrahedra int psi(F) dV
///       + sum over tetrahedra s V_e psi(F_e)
///       + sum over nodes [(1 - s) V_t psi(F_n) + V_n U(t_n)]
///
/// F_n is the mean of F_e over the tetrahedra around the node, V_t their share in the
/// node's volume V_n (nodal_patches.hpp). t_n is the mean of t(F_n), with the weight V_t,
/// and of the other cells' own means of t(F), each with its share. On a cell alone W is
/// that of q1 (tetrahedra) or q1_sri.
///
/// With the tetrahedra's own t_e instead of t(F_n) St-Venant's element would wrinkle at
/// strains of 4 %: the mean of tr E_e is tr E(F_n) and half the variance of F_e, which
/// displacements that F_n does not see lower for little (s) where the body is pressed.
///
/// The part s that stays on the tetrahedra holds what the means do not see: at s = 0 a
/// displacement that changes its sign from node to node can leave all F_n as they are. It
/// also makes them stiffer. Errors of Hooke's force in compression and shearing and of
/// the torque on gmsh's tetrahedra, 5 across, of what q2 converges to, in percent:
///
///     s          nu = 0               nu = .499
///     0          0   -4.8   -8.7      3.4    4.0   -5.6
///     .02        0   -4.3   -7.9      4.2    5.0   -4.6
///     .05        0   -3.8   -6.8      5.2    6.1   -3.2
///     .25        0   -1.2   -0.9     10.1   10.8    3.7
///     q1         0    7.4   18.1    350     34    326
///
/// s = .02 was chosen by this table, for nu near 1/2, where these elements are needed;
/// below they are too soft.
///
/// Source: t_n of other cells: Bonet and Burton 1998 (nodal_patches.hpp). F_n: Dohrmann,
/// Heinstein, Jung, Key and Witkowski 2000, Node-based uniform strain elements for
/// three-node triangular and four-node tetrahedral meshes, International Journal for
/// Numerical Methods in Engineering 47, 1549-1568. s: Puso and Solberg 2006, A stabilized
/// nodally integrated tetrahedral, the same journal 67, 841-867, whose stabilising part
/// is of a material of its own; here it is of the same shape part, and s is a number of
/// ours.
inline constexpr double tetrahedron_part = 0.02;

/// The nodal patches of a body in some state.
struct NodalPatchState {
  double energy;                    // [J]; infinite where det F_n <= 0 and the law ends
  std::vector<Matrix3> gradients;   // F_n - I; none without tetrahedra
  std::vector<double> dilatations;  // t_n
  std::vector<double> pressures;    // U'(t_n) [Pa]
  std::vector<FromNodalPatches> on_cells;  // one per cell; none without nodal patches
};
NodalPatchState nodal_patch_state(const CellLaw& law, const Discretisation& body,
                                  const Eigen::VectorXd& displacements);

/// Nodes of the cells around a node, ascending.
std::vector<NodeIndex> patch_nodes(const Discretisation& body, NodeIndex node);

/// A nodal patch's part of d2W/du2 [N/m], G^T A G + v d d^T with the map G from
/// displacements to F_n and the gradient d of t_n, A that of the tetrahedra with t'' at
/// constant U'; dof = 3 node + component of patch_nodes.
struct NodalPatchTangent {
  CellVectors gradients;             // of F_n, as of shape functions [1/m]
  Matrix9 shape;                     // A [J]
  CellVectors dilatation_gradients;  // d [1/m]
  double volumetric;                 // v [J]
};
NodalPatchTangent patch_tangent(const CellLaw& law, const Discretisation& body,
                                const Eigen::VectorXd& displacements,
                                const NodalPatchState& state, NodeIndex node);
CellMatrix matrix(const NodalPatchTangent& tangent);

}  // namespace springcheck::fem_reference
