#pragma once

#include "dynamics/blocks/paths.hpp"
#include "mss/tissue/tissue_block.hpp"

namespace springcheck::mss {

#define SPRINGCHECK_DECLARE(path)                         \
  namespace path {                                        \
  TissueFunction tissue_function(const TissueKind& kind); \
  }
SPRINGCHECK_FOR_EACH_PATH(SPRINGCHECK_DECLARE)
#undef SPRINGCHECK_DECLARE

}  // namespace springcheck::mss
