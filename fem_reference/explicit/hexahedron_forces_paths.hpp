#pragma once

#include "dynamics/blocks/paths.hpp"
#include "fem_reference/explicit/hexahedron_block.hpp"

namespace springcheck::fem_reference {

#define SPRINGCHECK_DECLARE(path)                                                 \
  namespace path {                                                                \
  HexahedronForces<double> hexahedron_forces(const HexahedronKind& kind, double); \
  HexahedronForces<float> hexahedron_forces(const HexahedronKind& kind, float);   \
  }
SPRINGCHECK_FOR_EACH_PATH(SPRINGCHECK_DECLARE)
#undef SPRINGCHECK_DECLARE

}  // namespace springcheck::fem_reference
