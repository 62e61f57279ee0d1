#pragma once

#include "fem_reference/explicit/hexahedron_block.hpp"

namespace springcheck::fem_reference {

#define SPRINGCHECK_DECLARE(path)                                                 \
  namespace path {                                                                \
  HexahedronForces<double> hexahedron_forces(const HexahedronKind& kind, double); \
  HexahedronForces<float> hexahedron_forces(const HexahedronKind& kind, float);   \
  }
SPRINGCHECK_DECLARE(portable)
SPRINGCHECK_DECLARE(avx2)
SPRINGCHECK_DECLARE(avx512)
#undef SPRINGCHECK_DECLARE

}  // namespace springcheck::fem_reference
