#pragma once

#include "dynamics/blocks/block_state.hpp"
#include "dynamics/blocks/instruction_set.hpp"
#include "mss/networks/network.hpp"

namespace springcheck::mss {

/// Forces of springs of constant rest length, of the cells' volume correction and, with a
/// damping ratio above 0, of the springs' dashpots on blocks of a grid: those of
/// nodal_forces and add_dashpot_forces, to 1e-13 (double) and 2e-6 (float) of the largest
/// k L, times kappa/(50 mu) where that is above 1, from nu = .49 on. Springs that blocks
/// share belong to the first of them.
///
/// The network has engineering or Green's strain, and no virtual springs, affine springs
/// or nodal patches: takes_lattice_kernel.
template <class Real>
dynamics::BlockForces<Real> lattice_kernel(const Network& network,
                                           const std::vector<dynamics::Block>& blocks,
                                           double damping_ratio,
                                           dynamics::InstructionSet set);

bool takes_lattice_kernel(const Network& network);

}  // namespace springcheck::mss
