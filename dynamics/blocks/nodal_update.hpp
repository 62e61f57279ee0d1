#pragma once

#include "dynamics/blocks/block_state.hpp"
#include "dynamics/blocks/instruction_set.hpp"
#include "dynamics/integrators.hpp"

namespace springcheck::dynamics {

/// One step of all nodes of a block, with a = (f + load fraction * load)/m.
struct NodalStep {
  Integrator integrator;  // not the implicit one
  double dt;              // [s]
  double kick;            // [s], see step()
  double load_fraction;
};

template <class Real>
using NodalUpdate = void (*)(const BlockArrays<Real>& arrays, const NodalStep& step);

template <class Real>
NodalUpdate<Real> nodal_update(InstructionSet set);

}  // namespace springcheck::dynamics
