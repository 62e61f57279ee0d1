#include "dynamics/nodal_update.hpp"

#include "dynamics/nodal_update_paths.hpp"

namespace springcheck::dynamics {

template <class Real>
NodalUpdate<Real> nodal_update(InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return avx512::update_nodes;
  if (set == InstructionSet::avx2) return avx2::update_nodes;
#endif
  return portable::update_nodes;
}

template NodalUpdate<double> nodal_update(InstructionSet set);
template NodalUpdate<float> nodal_update(InstructionSet set);

}  // namespace springcheck::dynamics
