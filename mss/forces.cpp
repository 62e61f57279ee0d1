#include "mss/forces.hpp"

#include <algorithm>
#include <cmath>

#include "meshing/traction.hpp"
#include "mss/cell.hpp"

namespace springcheck::mss {

double strain_energy(const Network& network, std::span<const Vector3> positions) {
  double energy = 0;
  for (const Spring& spring : network.springs) {
    const double elongation =
        (positions[spring.b] - positions[spring.a]).norm() - spring.rest_length;
    energy += spring.stiffness / 2 * elongation * elongation;
  }
  if (network.volume_modulus == 0) return energy;
  for (const Cell& cell : network.cells) {
    const double change =
        mean_edge_volume(corners(cell.nodes, positions)) - cell.rest_volume;
    energy += network.volume_modulus / 2 * change * change / cell.rest_volume;
  }
  return energy;
}

void nodal_forces(const Network& network, std::span<const Vector3> positions,
                  std::span<Vector3> forces) {
  std::ranges::fill(forces, Vector3::Zero());
  for (const Spring& spring : network.springs) {
    const Vector3 d = positions[spring.b] - positions[spring.a];
    const double length = d.norm();
    if (length == 0) continue;
    const Vector3 pull = spring.stiffness * (1 - spring.rest_length / length) * d;
    forces[spring.a] += pull;
    forces[spring.b] -= pull;
  }
  if (network.volume_modulus == 0) return;
  for (const Cell& cell : network.cells) {
    const CornerPositions x = corners(cell.nodes, positions);
    const double pressure = network.volume_modulus *
                            (mean_edge_volume(x) - cell.rest_volume) / cell.rest_volume;
    const auto gradient = mean_edge_volume_gradient(x);
    for (std::size_t i = 0; i < 8; ++i)
      forces[cell.nodes[i]] -= pressure * gradient.col(static_cast<Eigen::Index>(i));
  }
}

std::vector<Vector3> load_forces(const Mesh& mesh, const Scene& scene,
                                 const Network& network) {
  std::vector<Vector3> forces = traction_forces(mesh, scene);
  for (std::size_t n = 0; n < forces.size(); ++n)
    forces[n] += network.masses[n] * scene.gravity;
  return forces;
}

double dashpot_constant(const Network& network, const Spring& spring,
                        double damping_ratio) {
  const double m_a = network.masses[spring.a], m_b = network.masses[spring.b];
  return 2 * damping_ratio * std::sqrt(spring.stiffness * m_a * m_b / (m_a + m_b));
}

void add_dashpot_forces(const Network& network, double damping_ratio,
                        std::span<const Vector3> positions,
                        std::span<const Vector3> velocities, std::span<Vector3> forces) {
  for (const Spring& spring : network.springs) {
    const Vector3 d = positions[spring.b] - positions[spring.a];
    const double length_squared = d.squaredNorm();
    if (length_squared == 0) continue;
    const double approach = d.dot(velocities[spring.b] - velocities[spring.a]);
    const Vector3 pull =
        dashpot_constant(network, spring, damping_ratio) * approach / length_squared * d;
    forces[spring.a] += pull;
    forces[spring.b] -= pull;
  }
}

}  // namespace springcheck::mss
