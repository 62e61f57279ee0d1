#pragma once

#include "dynamics/blocks/paths.hpp"
#include "mss/kernels/lattice_block.hpp"

namespace springcheck::mss {

#define SPRINGCHECK_DECLARE(path)                                                \
  namespace path {                                                               \
  LatticeForces<double> lattice_forces(const LatticeKind& kind, double);         \
  LatticeForces<float> lattice_forces(const LatticeKind& kind, float);           \
  LatticeForces<double> squared_lattice_forces(const LatticeKind& kind, double); \
  LatticeForces<float> squared_lattice_forces(const LatticeKind& kind, float);   \
  }
SPRINGCHECK_FOR_EACH_PATH(SPRINGCHECK_DECLARE)
#undef SPRINGCHECK_DECLARE

}  // namespace springcheck::mss
