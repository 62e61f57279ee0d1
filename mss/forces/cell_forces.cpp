#include "mss/forces/cell_forces.hpp"

namespace springcheck::mss {

bool cells_act(const Network& network) {
  return network.spring_modulus != 0 || network.volume_moduli.act() ||
         network.cell_springs == RestLength::affine;
}

VirtualSprings law_of(const Network& network) {
  const bool corrects_cells = network.volume_patches.size() == 0;
  return {.shear_modulus = network.spring_modulus,
          .volume_moduli = corrects_cells ? network.volume_moduli : VolumeModuli{},
          .measure = network.strain_measure,
          .axes = network.axes};
}

double own_part(const Network& network, std::size_t cell) {
  const bool shares =
      network.shape_patches.size() > 0 && network.cells.is_tetrahedron(cell);
  return shares ? 1 - patch_part : 1;
}

void update_deformations(const Network& network, std::span<const Vector3> positions,
                         CellStates& states) {
  const Cells& cells = network.cells;
  states.displacements.resize(positions.size());
  for (std::size_t n = 0; n < positions.size(); ++n)
    states.displacements[n] = positions[n] - network.rest_positions[n];
  states.displacement_gradients.resize(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
    states.displacement_gradients[c] =
        cells.displacement_gradient(c, states.displacements);

  states.patch_gradients.resize(network.shape_patches.size());
  for (std::size_t n = 0; n < states.patch_gradients.size(); ++n) {
    Matrix3 mean = Matrix3::Zero();
    for (const auto& [cell, weight] : network.shape_patches[n])
      mean += weight * states.displacement_gradients[cell];
    states.patch_gradients[n] = mean;
  }
  states.patch_pressures.resize(network.volume_patches.size());
  if (states.patch_pressures.empty()) return;
  states.volume_changes.resize(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
    states.volume_changes[c] =
        volume_change(network.strain_measure, states.displacement_gradients[c]);
  states.patch_volume_changes.resize(states.patch_pressures.size());
  for (std::size_t n = 0; n < states.patch_pressures.size(); ++n) {
    double mean = 0;
    for (const auto& [cell, weight] : network.volume_patches[n])
      mean += weight * states.volume_changes[cell];
    states.patch_volume_changes[n] = mean;
    const VolumePull pull =
        volume_pull(network.strain_measure, network.volume_moduli, mean);
    states.patch_pressures[n] = pull.modulus * pull.first;
  }
}

double patch_pressure(const Network& network, const CellStates& states,
                      std::size_t cell) {
  const auto nodes = network.cells.nodes(cell);
  double sum = 0;
  for (const NodeIndex node : nodes) sum += states.patch_pressures[node];
  return sum / static_cast<double>(nodes.size());
}

double cells_energy(const Network& network, const CellStates& states) {
  const VirtualSprings law = law_of(network);
  double energy = 0;
  for (std::size_t c = 0; c < network.cells.size(); ++c) {
    energy += own_part(network, c) * network.cells.volume(c) *
              law.energy(states.displacement_gradients[c]);
    if (network.cell_springs == RestLength::affine)
      for_each_affine_spring(
          network, states, c, [&](const CellSpring& spring, const AffineSpring& now) {
            energy += spring.stiffness / 2 * now.elongation * now.elongation;
          });
  }
  for (std::size_t n = 0; n < states.patch_gradients.size(); ++n)
    energy += patch_part * network.shape_patches.volumes[n] *
              law.energy(states.patch_gradients[n]);
  for (std::size_t n = 0; n < states.patch_volume_changes.size(); ++n)
    energy += network.volume_patches.volumes[n] *
              volume_energy(network.strain_measure, network.volume_moduli,
                            states.patch_volume_changes[n]);
  return energy;
}

void add_cell_forces(const Network& network, std::span<const Vector3> positions,
                     CellStates& states, std::span<Vector3> forces) {
  update_deformations(network, positions, states);
  const VirtualSprings law = law_of(network);
  states.patch_stresses.resize(states.patch_gradients.size());
  for (std::size_t n = 0; n < states.patch_stresses.size(); ++n)
    if (!network.shape_patches[n].empty())
      states.patch_stresses[n] = law.stress(states.patch_gradients[n]);

  for (std::size_t c = 0; c < network.cells.size(); ++c) {
    const auto nodes = network.cells.nodes(c);
    const auto gradients = network.cells.gradients(c);
    const Matrix3& H = states.displacement_gradients[c];
    const double V = network.cells.volume(c), own = own_part(network, c);
    Matrix3 stress = own * V * law.stress(H);
    if (own != 1)
      for (const NodeIndex node : nodes)
        stress += patch_part * V / 4 * states.patch_stresses[node];
    if (!states.patch_pressures.empty())
      stress += V * patch_pressure(network, states, c) *
                volume_gradient(network.strain_measure, H);
    if (network.cell_springs == RestLength::affine)
      for_each_affine_spring(
          network, states, c, [&](const CellSpring& spring, const AffineSpring& now) {
            const double tension = spring.stiffness * now.elongation;
            const auto at = [&](double length) {
              return tension *
                     elongation_slopes(network.strain_measure, now.unit, length).first /
                     length;
            };
            const Vector3 pull = at(now.length) * now.d;
            forces[nodes[spring.ends[0]]] += pull;
            forces[nodes[spring.ends[1]]] -= pull;
            stress -= (at(now.rest_length) * now.rest) * spring.rest.transpose();
          });
    // The gradients' sum is zero, and with them that of the forces: to the bit.
    Vector3 rest = Vector3::Zero();
    for (std::size_t a = 1; a < nodes.size(); ++a) {
      const Vector3 push = stress * gradients[a];
      forces[nodes[a]] -= push;
      rest += push;
    }
    forces[nodes[0]] += rest;
  }
}

}  // namespace springcheck::mss
