#include "mss/forces/forces.hpp"

#include <algorithm>
#include <cmath>

namespace springcheck::mss {

double strain_energy(const Network& network, std::span<const Vector3> positions) {
  double energy = 0;
  for (const Spring& spring : network.springs) {
    const double length = (positions[spring.b] - positions[spring.a]).norm();
    energy += spring_energy(network.strain_measure, spring.stiffness, spring.rest_length,
                            length);
  }
  if (!cells_act(network)) return energy;
  CellStates states;
  update_deformations(network, positions, states);
  return energy + cells_energy(network, states);
}

void nodal_forces(const Network& network, std::span<const Vector3> positions,
                  CellStates& states, std::span<Vector3> forces) {
  std::ranges::fill(forces, Vector3::Zero());
  for (const Spring& spring : network.springs) {
    const Vector3 d = positions[spring.b] - positions[spring.a];
    const double length = d.norm();
    if (length == 0) continue;
    const Vector3 pull =
        spring.stiffness *
        spring_pull(network.strain_measure, spring.rest_length, length).over_length * d;
    forces[spring.a] += pull;
    forces[spring.b] -= pull;
  }
  if (cells_act(network)) add_cell_forces(network, positions, states, forces);
}

void nodal_forces(const Network& network, std::span<const Vector3> positions,
                  std::span<Vector3> forces) {
  CellStates states;
  nodal_forces(network, positions, states, forces);
}

double dashpot_constant(const Network& network, const Spring& spring,
                        double damping_ratio) {
  const double m_a = network.masses[spring.a], m_b = network.masses[spring.b];
  return 2 * damping_ratio * std::sqrt(spring.stiffness * m_a * m_b / (m_a + m_b));
}

void add_dashpot_forces(const Network& network, double damping_ratio,
                        std::span<const Vector3> positions,
                        std::span<const Vector3> velocities, std::span<Vector3> forces) {
  for_each_dashpot(network, [&](const Spring& spring) {
    const Vector3 d = positions[spring.b] - positions[spring.a];
    const double length_squared = d.squaredNorm();
    if (length_squared == 0) return;
    const double approach = d.dot(velocities[spring.b] - velocities[spring.a]);
    const Vector3 pull =
        dashpot_constant(network, spring, damping_ratio) * approach / length_squared * d;
    forces[spring.a] += pull;
    forces[spring.b] -= pull;
  });
}

}  // namespace springcheck::mss
