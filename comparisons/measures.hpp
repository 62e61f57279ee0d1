#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "comparisons/case.hpp"

namespace springcheck {

/// What is measured on a solution. A value that was not computed is empty, never 0.
/// SI units; fractions, not percent.
struct Measures {
  using Value = std::optional<double>;
  using Vector = std::optional<Vector3>;

  Value volume_error{};           // |V0 - V|/V0, exact trilinear volume
  Value volume_change{};          // (V - V0)/V0
  Value cell_volume_ratio_min{};  // V/V0 of a cell
  Value cell_volume_ratio_max{};
  Value corner_jacobian_ratio_min{};  // smallest corner Jacobian of a cell over its rest
                                      // value; the cell is inverted below 0

  // What the detector saw on the worst free face, see wrinkles.hpp:
  Value wrinkle_alternation{};
  Value wrinkle_amplitude{};

  // What the moved plate applies to the body; empty without a moved plate.
  Vector force{};       // [N]
  Vector torque{};      // [N m] about the plate's axis directions, through its centre
  Value plate_force{};  // component along the imposed motion; empty in torsion
  Value plate_force_norm{};  // length of the resultant
  Value plate_torque{};      // component about z

  // Distances between equal nodes of this solution and the reference's [m].
  Value mean_deviation{};  // mean over all nodes
  Value max_deviation{};
  Value middle_layer_deviation{};  // mean over the nodes at half height (the thesis's
                                   // measure); even cell counts only
  // Over the free nodes, divided by the largest imposed displacement (bending: by the
  // reference's tip deflection):
  Value deviation_l2_relative{};  // volume-weighted root mean square
  Value deviation_max_relative{};
  Value cell_volume_ratio_rms_difference{};  // volume-weighted, V/V0 against reference's

  // Bending: the tip is the node at the centre of the end face (even cell counts).
  Value tip_deflection{};       // [m] along gravity
  Value tip_euler_bernoulli{};  // [m] theories, see beam_theory.hpp
  Value tip_timoshenko{};
  Value tip_elastica{};
  // Largest distance between centre-line nodes and the theory's points [m].
  Value centre_line_euler_bernoulli{};
  Value centre_line_timoshenko{};
  Value centre_line_elastica{};

  Value strain_energy{};  // [J]
};

/// Calls visit(name, value) for every measure, in the order they are reported; names as
/// in JSON and result files. Works on const and mutable Measures.
template <class SomeMeasures, class Visit>
void for_each_measure(SomeMeasures& measures, Visit&& visit) {
  visit("volume_error", measures.volume_error);
  visit("volume_change", measures.volume_change);
  visit("cell_volume_ratio_min", measures.cell_volume_ratio_min);
  visit("cell_volume_ratio_max", measures.cell_volume_ratio_max);
  visit("corner_jacobian_ratio_min", measures.corner_jacobian_ratio_min);
  visit("wrinkle_alternation", measures.wrinkle_alternation);
  visit("wrinkle_amplitude", measures.wrinkle_amplitude);
  visit("force", measures.force);
  visit("torque", measures.torque);
  visit("plate_force", measures.plate_force);
  visit("plate_force_norm", measures.plate_force_norm);
  visit("plate_torque", measures.plate_torque);
  visit("mean_deviation", measures.mean_deviation);
  visit("max_deviation", measures.max_deviation);
  visit("middle_layer_deviation", measures.middle_layer_deviation);
  visit("deviation_l2_relative", measures.deviation_l2_relative);
  visit("deviation_max_relative", measures.deviation_max_relative);
  visit("cell_volume_ratio_rms_difference", measures.cell_volume_ratio_rms_difference);
  visit("tip_deflection", measures.tip_deflection);
  visit("tip_euler_bernoulli", measures.tip_euler_bernoulli);
  visit("tip_timoshenko", measures.tip_timoshenko);
  visit("tip_elastica", measures.tip_elastica);
  visit("centre_line_euler_bernoulli", measures.centre_line_euler_bernoulli);
  visit("centre_line_timoshenko", measures.centre_line_timoshenko);
  visit("centre_line_elastica", measures.centre_line_elastica);
  visit("strain_energy", measures.strain_energy);
}

/// All measures that need no reference.
Measures measure(const CaseSettings& settings, const Mesh& mesh,
                 const Solution& solution);

/// What deviations are measured against, at the nodes and in the cells of a mesh.
struct ReferenceField {
  std::vector<Vector3> displacements;
  std::vector<double> cell_volumes;  // [m^3] deformed
};

/// Deformed volume of each cell [m^3].
std::vector<double> deformed_cell_volumes(const Mesh& mesh, const Solution& solution);

/// Fills in the deviations of the solution from the reference's field.
void measure_deviation(Measures& measures, const CaseSettings& settings, const Mesh& mesh,
                       const Solution& solution, const ReferenceField& reference);

}  // namespace springcheck
