#pragma once

#include <span>

#include "mss/network.hpp"

namespace springcheck::mss {

/// Energy of springs and volume correction [J]:
///
///     W = sum k/2 (|d| - L)^2 + sum over cells kappa/2 (V - V0)^2 / V0
///
/// positions [m], one per node; V is mean_edge_volume.
/// Source: Golec 2018, Eq. 3.1 and 5.14 (V0 the cell's own).
double strain_energy(const Network& network, std::span<const Vector3> positions);

/// Forces on the nodes [N], minus the gradient of strain_energy: k (|d| - L) d/|d| along
/// each spring and -kappa (V - V0)/V0 dV/dx_i from each cell (Golec 2018, Eq. 5.17).
/// Overwrites `forces`. A spring of zero length pulls nowhere.
void nodal_forces(const Network& network, std::span<const Vector3> positions,
                  std::span<Vector3> forces);

/// Forces of the scene's loads on the nodes at the full load [N]: the weight of their
/// masses, and traction_forces.
std::vector<Vector3> load_forces(const Mesh& mesh, const Scene& scene,
                                 const Network& network);

/// Adds the pull of a dashpot along each spring, c (n . (v_b - v_a)) n on a and the
/// opposite on b, with c = 2 zeta sqrt(k m_a m_b/(m_a + m_b)) [N s/m]. Projected on the
/// spring's axis, it keeps angular momentum.
/// Source: critical damping of the two-mass oscillator; Golec 2018, Eq. 3.20 is not a
/// damping coefficient by its units, and Eq. 3.3 lacks the projection.
void add_dashpot_forces(const Network& network, double damping_ratio,
                        std::span<const Vector3> positions,
                        std::span<const Vector3> velocities, std::span<Vector3> forces);

/// The dashpot constant c above [N s/m].
double dashpot_constant(const Network& network, const Spring& spring,
                        double damping_ratio);

}  // namespace springcheck::mss
