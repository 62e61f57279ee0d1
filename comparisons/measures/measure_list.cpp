#include "comparisons/measures/measure_list.hpp"

namespace springcheck {

const std::vector<Described>& measure_list() {
  static const std::vector<Described> list{
      {"volume_error", "|V - V0|/V0 of the body", ""},
      {"volume_change", "(V - V0)/V0 of the body", ""},
      {"cell_volume_ratio_min", "smallest V/V0 of a cell", ""},
      {"cell_volume_ratio_max", "largest V/V0 of a cell", ""},
      {"corner_jacobian_ratio_min",
       "smallest corner Jacobian of a cell over its value at rest; below 0 the cell is "
       "inverted",
       ""},
      {"wrinkle_alternation",
       "how much of what the worst free side does between neighbouring nodes is a "
       "zigzag from cell to cell; none where the amplitude is round-off",
       ""},
      {"wrinkle_amplitude", "height of that zigzag over the cell edge", ""},
      {"hourglass_alternation",
       "how much of the hourglass displacement inside a body of hexahedra alternates "
       "from cell to cell; none where that displacement is round-off",
       ""},
      {"hourglass_amplitude", "height of that displacement over edge times strain", ""},
      {"force", "what the moved plate, or the traction, applies to the body (x, y, z)",
       "N"},
      {"torque",
       "the same about the plate's axis directions, through its centre; none in traction",
       "N m"},
      {"plate_force",
       "component of force along the motion or the traction, positive where the body "
       "resists; none in torsion",
       "N"},
      {"plate_force_norm", "length of force", "N"},
      {"plate_torque", "component of torque about z", "N m"},
      {"face_displacement",
       "traction: area-weighted mean displacement of the loaded face (x, y, z)", "m"},
      {"mean_stress",
       "affine: mean first Piola-Kirchhoff stress P = (1/V0) sum r (x) X of the "
       "boundary's reactions r, by rows; tension is positive, columns belong to "
       "undeformed normals",
       "Pa"},
      {"affine_deviation_relative",
       "affine: how far the inside is from u = H X, volume-weighted root mean square "
       "over the largest imposed displacement",
       ""},
      {"definite_up_to_deformation",
       "deformation up to which the states reached had a positive definite tangent, "
       "where that was lost on the way",
       ""},
      {"critical_wavelength",
       "of solver limit: wavelength of the mode that becomes unstable, in edges between "
       "neighbouring nodes, along the direction in which it is shortest",
       ""},
      {"mean_deviation",
       "mean distance between nodes of this solution and the reference's", "m"},
      {"max_deviation", "largest such distance", "m"},
      {"middle_layer_deviation",
       "mean distance over the nodes at half height (the thesis's measure); of regular "
       "grids of even cell counts only",
       "m"},
      {"deviation_l2_relative",
       "volume-weighted root mean square of that distance over the free nodes, divided "
       "by the largest imposed displacement (bending: by the reference's tip "
       "deflection; traction: by its face displacement)",
       ""},
      {"deviation_max_relative",
       "largest such distance over the free nodes, divided by the same", ""},
      {"cell_volume_ratio_rms_difference",
       "volume-weighted root mean square of the cells' V/V0 less the reference's", ""},
      {"reference_order", "order that the displacements of a converged reference show",
       ""},
      {"reference_bar", "how far a converged reference may be off, mean over the nodes",
       "m"},
      {"reference_bar_l2_relative", "the same, divided like deviation_l2_relative", ""},
      {"tip_deflection", "bending: displacement of the end face's centre along gravity",
       "m"},
      {"tip_euler_bernoulli", "bending: the tip by Euler and Bernoulli's theory", "m"},
      {"tip_timoshenko", "bending: the tip by Timoshenko's theory", "m"},
      {"tip_elastica", "bending: the tip by the elastica, of large rotations", "m"},
      {"centre_line_euler_bernoulli",
       "bending: largest distance between nodes of the centre line and that theory's "
       "points, across the plane of bending too; of regular grids of even counts only",
       "m"},
      {"centre_line_timoshenko", "bending: the same, Timoshenko's", "m"},
      {"centre_line_elastica", "bending: the same, the elastica's", "m"},
      {"strain_energy", "strain energy; none of a measured result", "J"},
      {"kinetic_energy", "dynamics: kinetic energy at the end", "J"},
      {"transit_count",
       "dynamics: how often a pressure wave runs through the body's height meanwhile, "
       "duration sqrt((lambda + 2 mu)/rho)/H",
       ""}};
  return list;
}

}  // namespace springcheck
