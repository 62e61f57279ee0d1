#pragma once

#include <string>

#include "comparisons/gates/outcome.hpp"

namespace springcheck::gates {

/// Judges the gate on the cases of a result file, which is named in messages.
///
/// A gate has no case where none matches, several do where one must, or those that do
/// cannot be compared: times of different sessions, grids of different shape, sweeps that
/// differ in a second setting. It falls short where a status is not expected, a measure
/// is null or the band is left. Throws InputError for columns that do not exist.
Outcome check(const Gate& gate, const Columns& cases, const std::string& file);

}  // namespace springcheck::gates
