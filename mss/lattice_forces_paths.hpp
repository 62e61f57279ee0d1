#pragma once

#include "mss/lattice_block.hpp"

namespace springcheck::mss {

#define SPRINGCHECK_DECLARE(path)                                        \
  namespace path {                                                       \
  LatticeForces<double> lattice_forces(const LatticeKind& kind, double); \
  LatticeForces<float> lattice_forces(const LatticeKind& kind, float);   \
  }
SPRINGCHECK_DECLARE(portable)
SPRINGCHECK_DECLARE(avx2)
SPRINGCHECK_DECLARE(avx512)
#undef SPRINGCHECK_DECLARE

}  // namespace springcheck::mss
