#pragma once

#include <span>

#include "mss/network.hpp"

namespace springcheck::mss {

/// What the cells' forces are computed from, kept from one state to the next so that no
/// memory is asked for in between. Vectors hold one entry per cell or per node, and none
/// where the network has no use for them.
struct CellStates {
  std::vector<Vector3> displacements;           // u of the nodes [m]
  std::vector<Matrix3> displacement_gradients;  // H = F - I of the cells
  std::vector<double> volume_changes;           // det F - 1 of the cells
  std::vector<Matrix3> star_gradients;          // H_n, mean of H over the shape star
  std::vector<Matrix3> star_stresses;           // P(F_n) [Pa]
  std::vector<double> star_pressures;           // p_n = kappa (J_n - 1) [Pa]
};

/// Whether the cells do anything beyond springs of constant rest length.
bool cells_act(const Network& network);

/// The law of the virtual springs, where they act: with the volume correction if that
/// acts there too.
VirtualSprings law_of(const Network& network);

/// How much of a cell's energy follows its own F: a quarter in a tetrahedron with shape
/// stars, which have the rest.
double own_part(const Network& network, std::size_t cell);
inline constexpr double star_part = 0.75;

/// Deformations of cells and stars; the stars' stresses are left as they are.
void update_deformations(const Network& network, std::span<const Vector3> positions,
                         CellStates& states);

/// Pressure on a cell from the stars of its nodes [Pa]: the mean of their p_n.
double star_pressure(const Network& network, const CellStates& states, std::size_t cell);

/// Of the network's energy the part of all cells [J], see strain_energy.
double cells_energy(const Network& network, const CellStates& states);

/// Adds the cells' forces to `forces`: updates the states, then per cell
///
///     P_e = own part P(F_e) + 3/4 mean of P(F_n) + mean of p_n cof F_e
///           - (1/V) sum over affine springs k (|d| - |F r|) F r/|F r| (x) r
///     f_a -= V P_e G_a
///
/// with means over the cell's nodes, and the springs' own pull.
void add_cell_forces(const Network& network, std::span<const Vector3> positions,
                     CellStates& states, std::span<Vector3> forces);

/// Calls visit(spring, d, e, m, L) for each spring of affine rest length of the cell: d
/// from end to end now, its elongation e = |d| - L, m = F r/L and L = |F r|. Leaves out
/// those of zero length.
template <class Visit>
void for_each_affine_spring(const Network& network, const CellStates& states,
                            std::size_t cell, Visit&& visit) {
  const auto nodes = network.cells.nodes(cell);
  const Matrix3& H = states.displacement_gradients[cell];
  for (const CellSpring& spring : network.cells.springs(cell)) {
    const Vector3 move = states.displacements[nodes[spring.ends[1]]] -
                         states.displacements[nodes[spring.ends[0]]];
    const Vector3 affine_move = H * spring.rest;
    const Vector3 d = spring.rest + move, Fr = spring.rest + affine_move;
    const double length = d.norm(), affine_length = Fr.norm();
    if (length == 0 || affine_length == 0) continue;
    // From the difference of d and F r: small elongations keep their digits.
    const double elongation = (move - affine_move).dot(d + Fr) / (length + affine_length);
    visit(spring, d, elongation, Vector3(Fr / affine_length), affine_length);
  }
}

}  // namespace springcheck::mss
