#pragma once

namespace springcheck {

/// ln(1 + x) - x with all its digits near x = 0, and -infinity at both ends of its range,
/// x = -1 and x = infinity, where energies that are made of it end as well.
double log1p_minus(double x);

}  // namespace springcheck
