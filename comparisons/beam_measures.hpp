#pragma once

#include <optional>
#include <span>

#include "comparisons/measures.hpp"

namespace springcheck {

/// Displacement along gravity of the node at the centre of the end face [m]; none where
/// there is no such node: cell counts must be even.
std::optional<double> tip_deflection(const CaseSettings& settings, const Mesh& mesh,
                                     std::span<const Vector3> displacements);

/// Fills in the measures of bending; leaves those of other tests alone.
void measure_beam(Measures& measures, const CaseSettings& settings, const Mesh& mesh,
                  std::span<const Vector3> displacements);

}  // namespace springcheck
