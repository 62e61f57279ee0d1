#pragma once

#include "dynamics/blocks/nodal_update.hpp"
#include "dynamics/blocks/paths.hpp"

namespace springcheck::dynamics {

#define SPRINGCHECK_DECLARE(path)              \
  namespace path {                             \
  NodalUpdate<double> update_of_nodes(double); \
  NodalUpdate<float> update_of_nodes(float);   \
  }
SPRINGCHECK_FOR_EACH_PATH(SPRINGCHECK_DECLARE)
#undef SPRINGCHECK_DECLARE

}  // namespace springcheck::dynamics
