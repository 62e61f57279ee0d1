#pragma once

#include "dynamics/blocks/paths.hpp"
#include "mss/kernels/affine_block.hpp"

namespace springcheck::mss {

#define SPRINGCHECK_DECLARE(path)                                           \
  namespace path {                                                          \
  AffineFunctions<double> affine_functions(const AffineKind& kind, double); \
  AffineFunctions<float> affine_functions(const AffineKind& kind, float);   \
  }
SPRINGCHECK_FOR_EACH_PATH(SPRINGCHECK_DECLARE)
#undef SPRINGCHECK_DECLARE

}  // namespace springcheck::mss
