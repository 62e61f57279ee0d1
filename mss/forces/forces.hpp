#pragma once

#include <span>

#include "mss/forces/cell_forces.hpp"
#include "mss/networks/network.hpp"

namespace springcheck::mss {

/// Energy of springs and cells [J]:
///
///     W = sum over springs k/2 L^2 s(|d|/L)^2
///       + sum over cells V psi(F)
///       + sum over their affine springs k/2 L^2 [s(|d|/L) - s(|F r|/L)]^2,   L = |r|
///
/// positions [m], one per node; s of the network's strain measure (StrainMeasure), psi of
/// VirtualSprings, with mu and kappa of the network. By engineering strains these are
/// k/2 (|d| - L)^2 and k/2 (|d| - |F r|)^2. For the methods of the thesis mu is 0, and
/// what is left of psi is then kappa/2 (V - V0)^2/V0 with the volume V of the mean edges:
/// on boxes that is V0 det F, F of the mean edges. It is not the volume of the deformed
/// cell with bilinear faces, by which bodies are measured: hourglasses of a cell change
/// that one alone, in the second order. As nu goes to 1/2 it is the mean edges' volume
/// that is kept (docs/explanation/limits.md has figures).
///
/// With patches of shape a tetrahedron has V/4 psi(F), and 3/4 V_n psi(F_n) is at each
/// node; with patches of volume psi is without kappa, and V_n U(t_n) is at each node. F_n
/// and t_n are means of F and of the volume change over the node's patch, V_n = sum V/n
/// over its cells.
///
/// Source: Golec 2018, Eq. 3.1, 5.14 (V0 the cell's own) and 5.19; virtual springs as
/// VirtualSprings; nodal patches as Bonet and Burton, Commun. Numer. Meth. Eng. 14 (1998)
/// 437.
double strain_energy(const Network& network, std::span<const Vector3> positions);

/// Forces on the nodes [N], minus the gradient of strain_energy: T d/|d| along each
/// spring, by engineering strains T = k (|d| - L), and add_cell_forces; from the volume
/// correction of a cell that is -kappa (V - V0)/V0 dV/dx_i (Golec 2018, Eq. 5.17).
/// Overwrites `forces`. A spring of zero length pulls nowhere. `states` is room to work
/// in, of any content.
void nodal_forces(const Network& network, std::span<const Vector3> positions,
                  CellStates& states, std::span<Vector3> forces);
void nodal_forces(const Network& network, std::span<const Vector3> positions,
                  std::span<Vector3> forces);

/// Adds the pull of a dashpot along each spring and damped edge, c (n . (v_b - v_a)) n on
/// a and the opposite on b, with c = 2 zeta sqrt(k m_a m_b/(m_a + m_b)) [N s/m].
/// Projected on the spring's axis, it keeps angular momentum. Source: critical damping of
/// the two-mass oscillator; Golec 2018, Eq. 3.20 is not a damping coefficient by its
/// units, and Eq. 3.3 lacks the projection.
void add_dashpot_forces(const Network& network, double damping_ratio,
                        std::span<const Vector3> positions,
                        std::span<const Vector3> velocities, std::span<Vector3> forces);

/// The dashpot constant c above [N s/m].
double dashpot_constant(const Network& network, const Spring& spring,
                        double damping_ratio);

/// Calls visit(spring) for each spring and damped edge.
template <class Visit>
void for_each_dashpot(const Network& network, Visit&& visit) {
  for (const Spring& spring : network.springs) visit(spring);
  for (const Spring& spring : network.damped_edges) visit(spring);
}

}  // namespace springcheck::mss
