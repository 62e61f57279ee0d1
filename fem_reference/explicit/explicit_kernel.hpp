#pragma once

#include "dynamics/blocks/block_state.hpp"
#include "dynamics/blocks/instruction_set.hpp"
#include "fem_reference/explicit/explicit_element.hpp"
#include "meshing/loads/scene.hpp"

namespace springcheck::fem_reference {

/// Forces of the elements on blocks of hexahedra: those of plain_forces to 1e-13 (double)
/// and 2e-6 (float) of the largest, and of a drag in proportion to the masses,
///
///     f_a -= alpha m_a v_a,   alpha = drag_rate [1/s]
///
/// of which each block has the part of its own cells.
template <class Real>
dynamics::BlockForces<Real> explicit_kernel(const Mesh& mesh, const Material& material,
                                            ExplicitElement element,
                                            const std::vector<dynamics::Block>& blocks,
                                            double drag_rate,
                                            dynamics::InstructionSet set);

}  // namespace springcheck::fem_reference
