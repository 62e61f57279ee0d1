#pragma once

#include "dynamics/nodal_update.hpp"

namespace springcheck::dynamics {

#define SPRINGCHECK_DECLARE(path)                                             \
  namespace path {                                                            \
  void update_nodes(const BlockArrays<double>& arrays, const NodalStep& now); \
  void update_nodes(const BlockArrays<float>& arrays, const NodalStep& now);  \
  }
SPRINGCHECK_DECLARE(portable)
SPRINGCHECK_DECLARE(avx2)
SPRINGCHECK_DECLARE(avx512)
#undef SPRINGCHECK_DECLARE

}  // namespace springcheck::dynamics
