#pragma once

#include "comparisons/formats/table.hpp"
#include "meshing/quality.hpp"

namespace springcheck {

/// The cells of a mesh by type, and of all; JSON tells their histograms, too, how many
/// have a scaled Jacobian in [0, 0.1), [0.1, 0.2), ..., [0.9, 1].
Table quality_table(const Quality& quality);

/// The histogram of all cells.
std::string histogram_text(const Quality& quality);

}  // namespace springcheck
