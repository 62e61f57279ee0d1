#include "dynamics/blocks/nodal_update.hpp"

#include "dynamics/blocks/nodal_update_paths.hpp"

namespace springcheck::dynamics {

template <class Real>
NodalUpdate<Real> nodal_update(InstructionSet set) {
  return SPRINGCHECK_ON_PATH(set, update_of_nodes(Real{}));
}

template NodalUpdate<double> nodal_update(InstructionSet set);
template NodalUpdate<float> nodal_update(InstructionSet set);

}  // namespace springcheck::dynamics
