#pragma once

#include <span>
#include <vector>

#include "dynamics/block_state.hpp"

namespace springcheck::dynamics {

/// The forces of a kernel on every node [N], summed over the blocks.
template <class Real>
std::vector<Vector3> summed_forces(const std::vector<Block>& blocks,
                                   const BlockForces<Real>& forces,
                                   std::span<const Vector3> displacements,
                                   std::span<const Vector3> velocities,
                                   std::span<const double> masses) {
  std::vector<Vector3> sum(displacements.size(), Vector3::Zero());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    BlockState<Real> state(blocks[b], Load::none, forces.lanes);
    const BlockArrays<Real>& arrays = state.arrays();
    const auto for_each_node = [&](const auto& visit) {
      for (std::size_t slot = 0; slot < blocks[b].nodes.size(); ++slot)
        if (blocks[b].nodes[slot] != no_node)
          for (int i = 0; i < 3; ++i)
            visit(arrays.element(slot), blocks[b].nodes[slot], i,
                  static_cast<std::size_t>(i));
    };
    for_each_node([&](std::size_t at, NodeIndex node, int i, std::size_t j) {
      arrays.displacement[j][at] = static_cast<Real>(displacements[node][i]);
      arrays.velocity[j][at] = static_cast<Real>(velocities[node][i]);
      arrays.inverse_mass[at] = static_cast<Real>(1 / masses[node]);
    });
    forces.add(b, arrays);
    for_each_node([&](std::size_t at, NodeIndex node, int i, std::size_t j) {
      sum[node][i] += double{arrays.force[j][at]};
    });
  }
  return sum;
}

}  // namespace springcheck::dynamics
