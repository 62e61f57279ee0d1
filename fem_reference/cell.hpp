#pragma once

#include <array>

#include "fem_reference/materials.hpp"

namespace springcheck::fem_reference {

/// One vector per corner of a hexahedron, as columns.
using CellVectors = Eigen::Matrix<double, 3, 8>;
using CellMatrix = Eigen::Matrix<double, 24, 24>;

struct GaussPoint {
  CellVectors gradients;  // of the shape functions [1/m]
  double weight;          // [m^3]
};

/// The undeformed cell as its integrals see it. The order of corners is that of `nodes`.
struct Cell {
  std::array<NodeIndex, 8> nodes;
  std::array<GaussPoint, 8> points;
  std::array<double, 8> shares;  // int N_a dV [m^3]
  double volume;                 // [m^3]
};

/// A law as the cells integrate it:
///
///     W_cell = int psi(e) dV + V K/2 t^2,   t = (1/V) int tr e dV
///
/// q1: psi is the whole law and K = 0. q1_sri: psi is the shape part, K the bulk modulus.
/// For Hooke's law on parallelepipeds t is tr e at the centroid: selective reduced
/// integration. On other cells the centroid's value fails the patch test; the mean
/// passes.
///
/// Source of the mean dilatation: Nagtegaal, Parks and Rice, Comput. Methods Appl. Mech.
/// Eng. 4 (1974) 153; Hughes, The Finite Element Method (1987), section 4.5.
struct CellLaw {
  Law law;
  EnergyDensity psi;
  double bulk_modulus;  // K [Pa]
};
CellLaw cell_law(const Settings& settings, const LameConstants& lame);

struct CellState {
  double energy;             // W_cell [J]
  CellVectors forces;        // dW_cell/du [N]
  double smallest_jacobian;  // of det F over the Gauss points
  double gradient_square;    // int |H|^2 dV [m^3]
};
CellState cell_state(const CellLaw& law, const Cell& cell, const CellVectors& u);

/// d2W_cell/du2 [N/m], dof = 3 corner + component:
///
///     sum over points w B^T (dP/dF) B + K/V c c^T,   c = V dt/du = sum w d(tr e)/dF grad
///     N
///
/// where P is the stress of psi + K t tr e at constant t.
CellMatrix cell_tangent(const CellLaw& law, const Cell& cell, const CellVectors& u);

}  // namespace springcheck::fem_reference
