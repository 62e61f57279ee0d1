#pragma once

#include <array>
#include <optional>
#include <span>

#include "comparisons/measures/beam_theory.hpp"
#include "comparisons/measures/measures.hpp"

namespace springcheck {

/// Displacement along gravity of the node at the centre of the end face [m]; none where
/// there is no such node: cell counts must be even.
std::optional<double> tip_deflection(const CaseSettings& settings, const Mesh& mesh,
                                     std::span<const Vector3> displacements);

/// A block of this size [m], clamped at z = 0, as the beam theories know it; none unless
/// gravity [m/s^2] acts across one side of its section.
std::optional<Cantilever> cantilever(const std::array<double, 3>& size,
                                     const Material& material, const Vector3& gravity);

/// Fills in the measures of bending; leaves those of other tests alone.
void measure_beam(Measures& measures, const CaseSettings& settings, const Mesh& mesh,
                  std::span<const Vector3> displacements);

}  // namespace springcheck
