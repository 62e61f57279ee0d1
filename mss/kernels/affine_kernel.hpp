#pragma once

#include "dynamics/blocks/block_state.hpp"
#include "dynamics/blocks/instruction_set.hpp"
#include "mss/networks/network.hpp"

namespace springcheck::mss {

/// Forces of mss-affine on blocks of hexahedra, in a grid or not, and with a damping
/// ratio above 0 of its dashpots: those of nodal_forces and add_dashpot_forces, to 1e-13
/// (double) and 2e-6 (float) of the largest force, up to nu = .4999. Of a spring of zero
/// length, which nodal_forces leaves out, what it does to the cell's F stays.
template <class Real>
dynamics::BlockForces<Real> affine_kernel(const Network& network,
                                          const std::vector<dynamics::Block>& blocks,
                                          double damping_ratio,
                                          dynamics::InstructionSet set);

/// Whether the network has virtual springs in squared lengths, or along six axes by
/// engineering strains, and hexahedra alone.
bool takes_affine_kernel(const Network& network);

}  // namespace springcheck::mss
