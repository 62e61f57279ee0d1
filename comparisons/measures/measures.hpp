#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/cases/case.hpp"

namespace springcheck {

/// What is measured on a solution, at the load that it reached: of a motion at the one
/// with which its path ends. A value that was not computed is empty, never 0. SI units;
/// fractions, not percent.
struct Measures {
  using Value = std::optional<double>;
  using Vector = std::optional<Vector3>;
  using Matrix = std::optional<Eigen::Matrix3d>;

  Value volume_error{};           // |V0 - V|/V0, see deformed_volumes
  Value volume_change{};          // (V - V0)/V0
  Value cell_volume_ratio_min{};  // V/V0 of a cell
  Value cell_volume_ratio_max{};
  Value corner_jacobian_ratio_min{};  // smallest corner Jacobian of a cell over its rest
                                      // value; the cell is inverted below 0

  // What the detector saw on the worst side of the free surface, see wrinkles.hpp; empty
  // without a free node inside a side:
  Value wrinkle_alternation{};
  Value wrinkle_amplitude{};
  // Inside a body of hexahedra, see hourglassing.hpp; empty on other cells, and without a
  // node inside:
  Value hourglass_alternation{};
  Value hourglass_amplitude{};

  // What the moved plate, or the traction in its stead, applies to the body; empty
  // without either, and where no forces were given to a measured result.
  Vector force{};   // [N]
  Vector torque{};  // [N m] about the plate's axis directions, through its centre; empty
                    // in traction, which has none about the loaded face's
  Value plate_force{};  // component along the imposed motion or the traction, so positive
                        // where that is resisted; once the load is gone along what it
                        // was; empty in torsion
  Value plate_force_norm{};  // length of the resultant
  Value plate_torque{};      // component about z

  // Traction: area-weighted mean displacement of the loaded face [m], int u dA/A with the
  // element's own u (springs: bilinear on each face of a cell).
  Vector face_displacement{};

  // Affine: mean first Piola-Kirchhoff stress [Pa], positive in tension; its columns
  // belong to undeformed normals. From the boundary's reactions r, as in equilibrium
  // int P dV = int t (x) X dA:
  //
  //     P = (1/V0) sum r (x) X
  Matrix mean_stress{};
  // How far the inside is from u = H X: volume-weighted root mean square over the free
  // nodes, divided by the largest imposed displacement.
  Value affine_deviation_relative{};

  // Deformation up to which the tangent was positive definite, where that was lost on the
  // way: load fraction times deformation. Known of runs that found no equilibrium too;
  // empty in tests without a deformation.
  Value definite_up_to_deformation{};
  // Of solver limit: wavelength of the mode that becomes unstable there, in edges between
  // nodes, along the direction in which it is shortest. Below 4 it is a wrinkle, else it
  // buckles.
  Value critical_wavelength{};

  // Distances between equal nodes of this solution and the reference's [m].
  Value mean_deviation{};  // mean over all nodes
  Value max_deviation{};
  Value middle_layer_deviation{};  // mean over the nodes at half height (the thesis's
                                   // measure); regular grids of even
                                   // cell counts only
  // Over the nodes with a free component, divided by the largest displacement imposed on
  // the way (bending: by the reference's tip deflection; traction: by its face
  // displacement; both empty without a load at the end):
  Value deviation_l2_relative{};  // volume-weighted root mean square
  Value deviation_max_relative{};
  Value cell_volume_ratio_rms_difference{};  // volume-weighted, V/V0 against reference's
  // Of a reference on three grids: the order its displacements show, none if they show
  // none, and the distance they may be off; see converged.hpp.
  Value reference_order{};
  Value reference_bar{};              // mean over all nodes [m]
  Value reference_bar_l2_relative{};  // as deviation_l2_relative

  // Bending of blocks: the tip is the centre of the end face, a node with even cell
  // counts; with others the displacement is interpolated there.
  Value tip_deflection{};       // [m] along gravity
  Value tip_euler_bernoulli{};  // [m] theories, see beam_theory.hpp
  Value tip_timoshenko{};
  Value tip_elastica{};
  // Largest distance between centre-line nodes and the theory's points [m].
  Value centre_line_euler_bernoulli{};
  Value centre_line_timoshenko{};
  Value centre_line_elastica{};

  Value strain_energy{};  // [J]; empty of a measured result

  // Dynamics: kinetic energy at the end [J], and how often a pressure wave runs through
  // the body's height meanwhile, duration sqrt((lambda + 2 mu)/rho)/H. With few of them
  // the end is not what rest would be.
  Value kinetic_energy{};
  Value transit_count{};
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
  visit("hourglass_alternation", measures.hourglass_alternation);
  visit("hourglass_amplitude", measures.hourglass_amplitude);
  visit("force", measures.force);
  visit("torque", measures.torque);
  visit("plate_force", measures.plate_force);
  visit("plate_force_norm", measures.plate_force_norm);
  visit("plate_torque", measures.plate_torque);
  visit("face_displacement", measures.face_displacement);
  visit("mean_stress", measures.mean_stress);
  visit("affine_deviation_relative", measures.affine_deviation_relative);
  visit("definite_up_to_deformation", measures.definite_up_to_deformation);
  visit("critical_wavelength", measures.critical_wavelength);
  visit("mean_deviation", measures.mean_deviation);
  visit("max_deviation", measures.max_deviation);
  visit("middle_layer_deviation", measures.middle_layer_deviation);
  visit("deviation_l2_relative", measures.deviation_l2_relative);
  visit("deviation_max_relative", measures.deviation_max_relative);
  visit("cell_volume_ratio_rms_difference", measures.cell_volume_ratio_rms_difference);
  visit("reference_order", measures.reference_order);
  visit("reference_bar", measures.reference_bar);
  visit("reference_bar_l2_relative", measures.reference_bar_l2_relative);
  visit("tip_deflection", measures.tip_deflection);
  visit("tip_euler_bernoulli", measures.tip_euler_bernoulli);
  visit("tip_timoshenko", measures.tip_timoshenko);
  visit("tip_elastica", measures.tip_elastica);
  visit("centre_line_euler_bernoulli", measures.centre_line_euler_bernoulli);
  visit("centre_line_timoshenko", measures.centre_line_timoshenko);
  visit("centre_line_elastica", measures.centre_line_elastica);
  visit("strain_energy", measures.strain_energy);
  visit("kinetic_energy", measures.kinetic_energy);
  visit("transit_count", measures.transit_count);
}

/// The measure of that name, of a vector its length; none without.
Measures::Value measure_of(const Measures& measures, std::string_view name);

/// The name of a measure that is not a finite number; none if all are that are known.
std::optional<std::string> not_finite(const Measures& measures);

/// Deformed volume of each cell [m^3]: the solution's own, or the exact trilinear one.
std::vector<double> deformed_volumes(const Mesh& mesh, const Solution& solution);

/// The measure of that name.
Measures::Value definite_up_to_deformation(const CaseSettings& settings,
                                           const Solution& solution);

/// All measures that need no reference.
Measures measure(const CaseSettings& settings, const Mesh& mesh,
                 const Solution& solution);

/// Fills in the deviations from the reference, a solution on the same mesh.
void measure_deviation(Measures& measures, const CaseSettings& settings, const Mesh& mesh,
                       const Solution& solution, const Solution& reference);

/// The measure of that name, of a reference on the mesh and the distance that it may be
/// off at each node [m], divided by what the settings' whole load imposes.
Measures::Value reference_bar_l2_relative(const CaseSettings& settings, const Mesh& mesh,
                                          const Solution& reference,
                                          const std::vector<double>& node_bars);

}  // namespace springcheck
