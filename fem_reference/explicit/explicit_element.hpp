#pragma once

namespace springcheck::fem_reference {

/// Trilinear hexahedra of St-Venant-Kirchhoff's law for explicit steps in time.
///
///     one_point      the law at the cell's mean gradient, hourglass control
///                    (hexahedra.hpp): does not lock
///     eight_points   2 x 2 x 2 Gauss points: q1 of fem-stvk, locks near nu = 1/2
enum class ExplicitElement { one_point, eight_points };

}  // namespace springcheck::fem_reference
