#pragma once

#include <span>

namespace springcheck::fem_reference {

/// How fast the free nodes move at a state on the path, as its tangent predicts.
struct Rate {
  double load_fraction;
  double displacement;  // |du/ds| [m]
};

/// Whether the rates, along the path up to its last state, rise towards the load fraction
/// of a step that failed as they do towards a limit point s_c, where the path turns back:
///
///     |du/ds| = regular part + c (s_c - s)^(-1/2)
///
/// From one distance to half of it and on to half of that, the slope of the second part
/// rises 2.8-fold, however small c is, and more if s_c lies before the failure. Asked
/// for: twofold, and a rate that itself rises by 1 % over the last of the two. Near any
/// other failure the slope hardly changes between steps that small; behind a
/// bifurcation's pole the rates fall.
bool limit_point_ahead(std::span<const Rate> rates, double failed);

}  // namespace springcheck::fem_reference
