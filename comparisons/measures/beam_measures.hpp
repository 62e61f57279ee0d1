#pragma once

#include <array>
#include <optional>
#include <span>

#include "comparisons/measures/beam_theory.hpp"
#include "comparisons/measures/measures.hpp"

namespace springcheck {

/// Displacement along gravity of the centre of the end face [m], see Measures; none where
/// the body is no block or has lost that face, and without gravity.
std::optional<double> tip_deflection(const CaseSettings& settings, const Mesh& mesh,
                                     std::span<const Vector3> displacements);

/// A block of this size [m], clamped at z = 0, as the beam theories know it; none unless
/// gravity [m/s^2] acts across one side of its section.
std::optional<Cantilever> cantilever(const std::array<double, 3>& size,
                                     const Material& material, const Vector3& gravity);

/// Fills in what beam theories say of a whole block that the settings' gravity bends, and
/// how far its centre line is from there.
void measure_theory(Measures& measures, const CaseSettings& settings, const Mesh& mesh,
                    std::span<const Vector3> displacements);

}  // namespace springcheck
