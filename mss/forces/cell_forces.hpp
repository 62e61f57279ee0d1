#pragma once

#include <span>

#include "mss/networks/network.hpp"

namespace springcheck::mss {

/// What the cells' forces are computed from, kept from one state to the next so that no
/// memory is asked for in between. Vectors hold one entry per cell or per node, and none
/// where the network has no use for them.
struct CellStates {
  std::vector<Vector3> displacements;           // u of the nodes [m]
  std::vector<Matrix3> displacement_gradients;  // H = F - I of the cells
  std::vector<double> volume_changes;           // t of the cells
  std::vector<Matrix3> patch_gradients;         // H_n, mean of H over the patch of shape
  std::vector<Matrix3> patch_stresses;          // P(F_n) [Pa]
  std::vector<double> patch_volume_changes;     // t_n, mean of t over that of volume
  std::vector<double> patch_pressures;          // p_n = U'(t_n) [Pa]
};

/// Whether the cells do anything beyond springs of constant rest length.
bool cells_act(const Network& network);

/// The law of the virtual springs, where they act: with the volume correction if that
/// acts there too.
VirtualSprings law_of(const Network& network);

/// How much of a cell's energy follows its own F: a quarter in a tetrahedron with patches
/// of shape, which have the rest.
double own_part(const Network& network, std::size_t cell);
inline constexpr double patch_part = 0.75;

/// Deformations of cells and nodal patches; the patches' stresses are left as they are.
void update_deformations(const Network& network, std::span<const Vector3> positions,
                         CellStates& states);

/// Pressure on a cell from the nodal patches of its nodes [Pa]: the mean of their p_n.
double patch_pressure(const Network& network, const CellStates& states, std::size_t cell);

/// The part of all cells in the network's energy [J], see strain_energy.
double cells_energy(const Network& network, const CellStates& states);

/// Adds the cells' forces to `forces`: updates the states, then per cell
///
///     P_e = own part P(F_e) + 3/4 mean of P(F_n) + mean of p_n dt/dF
///           - (1/V) sum over affine springs k e e' F r/|F r| (x) r
///     f_a -= V P_e G_a
///
/// with means over the cell's nodes, e of elongation and e' of elongation_slopes at
/// |F r|, and the springs' own pull.
void add_cell_forces(const Network& network, std::span<const Vector3> positions,
                     CellStates& states, std::span<Vector3> forces);

/// A spring of affine rest length in some state.
struct AffineSpring {
  Vector3 d;           // from end to end [m]
  double length;       // |d|
  Vector3 rest;        // F r [m]
  double rest_length;  // |F r|
  double unit;         // |r|; 1 by engineering strain, which has no use for it [m]
  double elongation;   // beyond |F r| by the strain measure, to small ones' digits
};

/// Calls visit(spring, affine spring) for each of the cell's springs of affine rest
/// length. Leaves out those of zero length.
template <class Visit>
void for_each_affine_spring(const Network& network, const CellStates& states,
                            std::size_t cell, Visit&& visit) {
  const auto nodes = network.cells.nodes(cell);
  const Matrix3& H = states.displacement_gradients[cell];
  for (const CellSpring& spring : network.cells.springs(cell)) {
    const Vector3 move = states.displacements[nodes[spring.ends[1]]] -
                         states.displacements[nodes[spring.ends[0]]];
    const Vector3 affine_move = H * spring.rest;
    AffineSpring now{.d = spring.rest + move,
                     .length = 0,
                     .rest = spring.rest + affine_move,
                     .rest_length = 0,
                     .unit = 1,
                     .elongation = 0};
    if (network.strain_measure != StrainMeasure::engineering)
      now.unit = spring.rest.norm();
    now.length = now.d.norm();
    now.rest_length = now.rest.norm();
    if (now.length == 0 || now.rest_length == 0) continue;
    now.elongation = elongation(network.strain_measure, now.unit,
                                (move - affine_move).dot(now.d + now.rest), now.length,
                                now.rest_length);
    visit(spring, now);
  }
}

}  // namespace springcheck::mss
