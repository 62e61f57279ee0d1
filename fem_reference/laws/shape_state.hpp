#pragma once

#include "fem_reference/laws/tensors.hpp"

namespace springcheck::fem_reference {

/// The energy and the stress of a law's shape part.
struct ShapeState {
  double energy;   // per undeformed volume [Pa]
  Matrix3 stress;  // first Piola-Kirchhoff stress [Pa]
};

/// The energy and the stress of any law's shape part.
template <class Law>
ShapeState shape_state(const Law& law, const Matrix3& displacement_gradient) {
  if constexpr (requires { law.shape_state(displacement_gradient); })
    return law.shape_state(displacement_gradient);
  else
    return {.energy = law.energy(displacement_gradient),
            .stress = law.stress(displacement_gradient)};
}

}  // namespace springcheck::fem_reference
