#pragma once

#include "comparisons/cases/method.hpp"
#include "mss/networks/spring_model.hpp"

namespace springcheck {

/// A method with what all methods of springs have. `coupling` is that of a solution's
/// systems above nu = 1/4.
Method of_springs(mss::SpringModel springs, Method own, double coupling = 1);

}  // namespace springcheck
