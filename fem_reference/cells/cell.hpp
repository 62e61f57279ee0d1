#pragma once

#include <memory>
#include <vector>

#include "fem_reference/laws/materials.hpp"

namespace springcheck::fem_reference {

/// One vector per node of a cell, as columns.
using CellVectors = Eigen::Matrix<double, 3, Eigen::Dynamic>;
using CellMatrix = Eigen::MatrixXd;

/// The shape functions' integrals over an undeformed cell.
struct Shape {
  // N_a(point q) as (q, a), one matrix for all cells of a type:
  std::shared_ptr<const Eigen::MatrixXd> values;
  Eigen::VectorXd weights;  // of the Gauss points [m^3]
  CellVectors gradients;    // of the shape functions [1/m], point after point; at the end
                            // their means over the cell
  Eigen::Index nodes;
  double volume;  // [m^3]

  [[nodiscard]] auto gradients_at(Eigen::Index point) const {
    return gradients.middleCols(point * nodes, nodes);
  }
  [[nodiscard]] auto mean_gradients() const { return gradients_at(weights.size()); }
};

/// A cell. Those that are translations of each other share a shape.
struct Cell {
  std::vector<NodeIndex> nodes;  // the corners first
  std::shared_ptr<const Shape> shape;
};

/// How an element takes the dilatation t of a law psi = shape part + U(t), and so its
/// energy:
///
///     at_points        W = int psi dV
///     cell_mean        W = int shape part dV + V U(t),   t = (1/V) int t(F) dV
///     of_mean_gradient W = int shape part dV + V U(t(F_mean)),  F_mean = (1/V) int F dV
///     patch_mean       W of the cells and of nodal patches, see nodal_patch_state.hpp
///
/// St-Venant's q1_sri is also described as mu E:E at the points and lambda/2 (tr E)^2 at
/// the centroid. That is another element: 13.871 and 6.375 % volume error in compression
/// by 20 % at nu = .25 and .499 (10^3 cells between glued plates), torque .060463 N m at
/// 45 degrees. Ours, mu dev(E):dev(E) at the points and K/2 of the mean tr E squared,
/// gives the figures that are known for this element: 13.822 and 6.397 %, .060333 N m.
///
/// On a tetrahedron the first three are the same. On parallelepipeds F_mean is F at the
/// centroid. Taken at the centroid of other cells the dilatation fails the patch test;
/// both means pass it.
/// Source: Nagtegaal, Parks and Rice, Comput. Methods Appl. Mech. Eng. 4 (1974) 153;
/// Hughes, The Finite Element Method (1987), section 4.5.
enum class DilatationTaken { at_points, cell_mean, of_mean_gradient, patch_mean };

/// How the element of the settings takes it: q1 and q2 at the points, q1_nodal as the
/// mean over nodal patches and q1_sri as the cell mean, but for Cauchy-Born of the mean
/// gradient, which is how the springs' volume correction sees a cell (Golec 2018, Eq.
/// 5.19). With green and for isochoric springs it is the cell mean again, as the laws
/// that they follow have it.
DilatationTaken dilatation_taken(const Settings& settings);

/// A law as the cells integrate it.
struct CellLaw {
  Constitution constitution;
  DilatationTaken dilatation;
};

/// What a cell takes from the nodal patches of its nodes with patch_mean; other elements
/// take nothing.
struct FromNodalPatches {
  double own_part = 1;               // of the shape part, at the cell's own points
  Matrix3 stress = Matrix3::Zero();  // of a tetrahedron, by the nodal patches' F_n [Pa]
  double pressure = 0;               // U' of another cell, by the nodal patches' t_n [Pa]
};

struct CellState {
  double energy;             // W [J]
  CellVectors forces;        // dW/du [N]
  double smallest_jacobian;  // of det F over the Gauss points
};
CellState cell_state(const CellLaw& law, const Shape& shape, const CellVectors& u,
                     const FromNodalPatches& nodal_patches = {});

/// t(F) at a point, (1/V) int t(F) dV of a cell, and the gradient of int t(F) dV by u,
/// one column per node.
Dilatation dilatation(const CellLaw& law, const Matrix3& displacement_gradient);
double mean_dilatation(const CellLaw& law, const Shape& shape, const CellVectors& u);
CellVectors integrated_dilatation_gradient(const CellLaw& law, const Shape& shape,
                                           const CellVectors& u);

double gradient_square(const Shape& shape, const CellVectors& u);  // int |H|^2 dV [m^3]
double deformed_volume(const Shape& shape, const CellVectors& u);  // int det F dV [m^3]

/// d2W/du2 [N/m], dof = 3 node + component:
///
///     sum over points w B^T (dP/dF) B + V U''(t) c c^T,   c = dt/du
///
/// the second term for a cell's mean dilatation only; P is the stress of the shape part
/// and of U'(t) dt/dF at constant U'(t).
CellMatrix cell_tangent(const CellLaw& law, const Shape& shape, const CellVectors& u,
                        const FromNodalPatches& nodal_patches = {});

}  // namespace springcheck::fem_reference
