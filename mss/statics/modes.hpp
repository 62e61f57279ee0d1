#pragma once

#include <vector>

#include "mss/networks/network.hpp"
#include "statics/systems/natural_modes.hpp"

namespace springcheck::mss {

/// The lowest `count` modes of small undamped vibrations about the rest state: stiffness
/// from the tangent there, masses in the nodes. Rows of the shapes are components, 3 node
/// + component, 0 where prescribed. None where the rest state is unstable.
/// is_free: one entry per component.
std::optional<NaturalModes> rest_modes(const Network& network,
                                       const std::vector<bool>& is_free, int count);

}  // namespace springcheck::mss
