#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparisons/store/columns.hpp"

namespace springcheck {

/// What a report says beside a result file's cases: what the methods are, and closed
/// forms for its figures.
///
///     methods          description by name
///     volume_modulus   nu, kappa_over_young: volume_correction_modulus over E; cases:
///     the
///                      same of every nu in the file
///     beams            of every distinct beam among the cases of bending: cases (keys),
///                      length, width, height [m], young [Pa], nu, density [kg/m^3],
///                      gravity [m/s^2] as far as it acts where the cases end, arc_length
///                      [m], and by euler_bernoulli, timoshenko and elastica drop and
///                      axial of a BeamPoint [m]
nlohmann::ordered_json theory_curves(const Columns& cases);

}  // namespace springcheck
