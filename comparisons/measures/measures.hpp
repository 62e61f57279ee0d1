#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/cases/case.hpp"
#include "comparisons/measures/measure_list.hpp"

namespace springcheck {

/// The value of the measure that has the name: of a vector its length, of a matrix its
/// Frobenius norm. There may be none.
Measures::Value measure_of(const Measures& measures, std::string_view name);

/// The name of a measure that is not a finite number; none if all are that are known.
std::optional<std::string> not_finite(const Measures& measures);

/// Deformed volume of each cell [m^3]: the solution's own, or the exact trilinear one.
std::vector<double> deformed_volumes(const Mesh& mesh, const Solution& solution);

/// The measure definite_up_to_deformation of a solution.
Measures::Value definite_up_to_deformation(const CaseSettings& settings,
                                           const Solution& solution);

/// All measures that need no reference.
Measures measure(const CaseSettings& settings, const Mesh& mesh,
                 const Solution& solution);

/// Fills in the deviations from the reference, a solution on the same mesh.
void measure_deviation(Measures& measures, const CaseSettings& settings, const Mesh& mesh,
                       const Solution& solution, const Solution& reference);

/// The measure reference_bar_l2_relative of a reference on the mesh and the distance that
/// it may be off at each node [m], divided by what the settings' whole load imposes.
Measures::Value reference_bar_l2_relative(const CaseSettings& settings, const Mesh& mesh,
                                          const Solution& reference,
                                          const std::vector<double>& node_error_bounds);

}  // namespace springcheck
