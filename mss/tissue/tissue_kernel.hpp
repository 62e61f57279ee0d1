#pragma once

#include <functional>
#include <memory>

#include "dynamics/blocks/block_state.hpp"
#include "dynamics/blocks/instruction_set.hpp"
#include "mss/tissue/tissue_body.hpp"

namespace springcheck::mss {

/// Forces of tissue on blocks, and what it remembers.
struct TissueForces {
  dynamics::BlockForces<double> forces;
  // What forces.add makes of the memories before it takes their stress; where it points
  // to none they stay as they are:
  std::shared_ptr<const tissue::MemoryStep*> step;
  // A_i as memories_at_rest has them, beside a C^-1 of no meaning; given the blocks:
  std::function<std::vector<double>(const std::vector<dynamics::Block>& blocks)> memories;
};

/// The forces on blocks of hexahedra, in a grid or not: nodal_forces of stresses_at,
/// after a step of mss::advance where there is one, to 1e-12 of the largest force. The
/// body outlives them.
TissueForces tissue_kernel(const TissueBody& body,
                           const std::vector<dynamics::Block>& blocks,
                           dynamics::InstructionSet set);

/// The same of any cells by those functions themselves, on whole_mesh.
TissueForces plain_tissue_forces(const TissueBody& body);

}  // namespace springcheck::mss
