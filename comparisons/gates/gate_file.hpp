#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "comparisons/gates/gate.hpp"

namespace springcheck::gates {

/// A gate file:
///
///     where = { element = "q1-sri" }       # of every gate, for cases that read it
///     fixed = true                         # --bless leaves the stored values alone
///
///     [[gate]]
///     name = "volume in compression"
///     where = { scene = "compression", method = "mss-cf", nu = 0.25 }
///     measure = "volume_error"
///     equals = 0.0317
///     absolute = 5e-5
///     reason = "half a unit of the last digit that is printed"
///
/// All keys: gate_keys.hpp. Throws InputError with file, line and column for whatever is
/// unknown, missing, of another type or contradicts itself.
std::vector<Gate> parse_gates(std::string_view text, const std::string& file);

}  // namespace springcheck::gates
