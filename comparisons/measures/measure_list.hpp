#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "comparisons/cases/test.hpp"
#include "meshing/basics/vector3.hpp"

namespace springcheck {

/// What is measured on a solution, at the load that it reached: of a motion at the one
/// with which its path ends. A value that was not computed is empty, never 0. SI units;
/// fractions, not percent. measure_list tells what each is.
struct Measures {
  using Value = std::optional<double>;
  using Vector = std::optional<Vector3>;
  using Matrix = std::optional<Eigen::Matrix3d>;

  // The body's volume and its cells':
  Value volume_error{}, volume_change{};
  Value cell_volume_ratio_min{}, cell_volume_ratio_max{}, corner_jacobian_ratio_min{};

  // Wrinkling of the worst side of the free surface, see wrinkles.hpp; empty without a
  // free node inside a side. Hourglassing inside a body of hexahedra, see
  // hourglassing.hpp; empty on other cells, and without a node inside:
  Value wrinkle_alternation{}, wrinkle_amplitude{};
  Value hourglass_alternation{}, hourglass_amplitude{};

  // Measures of the moved plate or the traction; empty without either, and where no
  // forces were given to a measured result:
  Vector force{}, torque{};
  Value plate_force{}, plate_force_norm{}, plate_torque{};
  Vector face_displacement{};

  // Measures of affine boundaries:
  Matrix mean_stress{};
  Value affine_deviation_relative{};

  // How far the body was stable; known of runs that found no equilibrium, too:
  Value definite_up_to_deformation{}, critical_wavelength{};

  // Measures against a reference. The relative ones of bending and traction are empty
  // without a load at the end:
  Value mean_deviation{}, max_deviation{}, middle_layer_deviation{};
  Value deviation_l2_relative{}, deviation_max_relative{};
  Value cell_volume_ratio_rms_difference{};
  Value reference_order{}, reference_bar{}, reference_bar_l2_relative{};

  // Measures of beams, see beam_theory.hpp. With odd cell counts, which have no node at
  // the centre of the end face, the tip is interpolated:
  Value tip_deflection{};
  Value tip_euler_bernoulli{}, tip_timoshenko{}, tip_elastica{};
  Value centre_line_euler_bernoulli{}, centre_line_timoshenko{}, centre_line_elastica{};

  // Energies:
  Value strain_energy{}, kinetic_energy{}, transit_count{};

  // Times; empty of a measured result:
  Value wall_s{}, solve_wall_s{};
};

/// How a measure is held against a reference's.
enum class Compared { by_ratio, by_difference, is_deviation, never };

template <>
inline constexpr std::array value_names<Compared>{
    Named{Compared::by_ratio, "ratio", "its difference over the reference's own"},
    Named{Compared::by_difference, "difference", "its difference from the reference's"},
    Named{Compared::is_deviation, "deviation", "it tells of a reference already"},
    Named{Compared::never, "none", "it depends on the problem alone"}};

/// All there is to know of a measure but how it is computed. Result files and their
/// tables, JSON, gates, the list of measures and the report read it here.
struct Measure {
  using Member = std::variant<Measures::Value Measures::*, Measures::Vector Measures::*,
                              Measures::Matrix Measures::*>;

  std::string_view name;  // in result files, JSON and gates
  Member member;
  std::string_view label;  // for people, in tables and figures
  std::string_view unit;   // SI; empty of fractions and ratios
  std::string_view description;

  struct Traits {
    Compared compared = Compared::by_ratio;
    bool (*is_of)(const TestName&) = [](const TestName&) { return true; };
    bool in_percent = false;  // how people read it
    bool is_time = false;     // which only one session on one machine can compare
    bool along_last_load = false;  // positive along the load that acted last
  } traits{};
};

namespace measure_table {

using enum Compared;
using M = Measures;

constexpr bool with_moved_plate(const TestName& test) {
  return test.deforms;
}
constexpr bool with_upper_plate(const TestName& test) {
  return test.upper_plate;
}
constexpr bool with_pushed_plate(const TestName& test) {
  return test.upper_plate && !test.turns;
}
constexpr bool with_traction(const TestName& test) {
  return test.value == Test::traction;
}
constexpr bool with_affine_boundary(const TestName& test) {
  return test.value == Test::affine;
}
constexpr bool of_beam(const TestName& test) {
  return test.value == Test::bending;
}
constexpr bool with_free_surface(const TestName& test) {
  return test.value != Test::affine;
}

/// Every measure: name, member, label, unit, what it is, and what else there is to say.
// clang-format off
inline constexpr Measure table[] = {
    {"volume_error", &M::volume_error, "volume change, absolute", "",
     "|V - V0|/V0 of the body",
     {.compared = by_difference, .in_percent = true}},
    {"volume_change", &M::volume_change, "volume change", "",
     "(V - V0)/V0 of the body",
     {.compared = by_difference, .in_percent = true}},
    {"cell_volume_ratio_min", &M::cell_volume_ratio_min, "least V/V0", "",
     "smallest V/V0 of a cell",
     {.compared = by_difference}},
    {"cell_volume_ratio_max", &M::cell_volume_ratio_max, "largest V/V0", "",
     "largest V/V0 of a cell",
     {.compared = by_difference}},
    {"corner_jacobian_ratio_min", &M::corner_jacobian_ratio_min,
     "least corner Jacobian ratio", "",
     "smallest corner Jacobian of a cell over its value at rest; below 0 the cell is "
     "inverted",
     {.compared = by_difference}},
    {"wrinkle_alternation", &M::wrinkle_alternation, "wrinkle alternation", "",
     "how much of what the worst free side does between neighbouring nodes is a "
     "zigzag from cell to cell; none where the amplitude is round-off",
     {.compared = by_difference, .is_of = with_free_surface}},
    {"wrinkle_amplitude", &M::wrinkle_amplitude, "wrinkle amplitude", "",
     "height of that zigzag over edge times strain of the surface",
     {.compared = by_difference, .is_of = with_free_surface}},
    {"hourglass_alternation", &M::hourglass_alternation, "hourglass alternation", "",
     "how much of the hourglass displacement inside a body of hexahedra alternates "
     "from cell to cell; none where that displacement is round-off",
     {.compared = by_difference}},
    {"hourglass_amplitude", &M::hourglass_amplitude, "hourglass amplitude", "",
     "height of that displacement over edge times strain",
     {.compared = by_difference}},
    {"force", &M::force, "force", "N",
     "what the moved plate, or the traction, applies to the body (x, y, z)",
     {.is_of = with_upper_plate}},
    {"torque", &M::torque, "torque vector", "N m",
     "the same about the plate's axis directions, through its centre",
     {.is_of = with_moved_plate}},
    {"plate_force", &M::plate_force, "plate force", "N",
     "component of force along the imposed motion or the traction, positive where the "
     "body resists; once the load is gone along what it was",
     {.is_of = with_pushed_plate, .along_last_load = true}},
    {"plate_force_norm", &M::plate_force_norm, "resultant force", "N",
     "length of force",
     {.is_of = with_upper_plate}},
    {"plate_torque", &M::plate_torque, "torque", "N m",
     "component of torque about z",
     {.is_of = with_moved_plate}},
    {"face_displacement", &M::face_displacement, "face displacement", "m",
     "area-weighted mean displacement of the loaded face (x, y, z), int u dA/A with "
     "the element's own u (springs: bilinear on each face of a cell)",
     {.is_of = with_traction}},
    {"mean_stress", &M::mean_stress, "mean stress", "Pa",
     "mean first Piola-Kirchhoff stress P = (1/V0) sum r (x) X of the boundary's "
     "reactions r, by rows; tension is positive, columns belong to undeformed normals",
     {.is_of = with_affine_boundary}},
    {"affine_deviation_relative", &M::affine_deviation_relative, "affine deviation", "",
     "how far the inside is from u = H X, volume-weighted root mean square over the "
     "free nodes, divided by the largest imposed displacement",
     {.compared = by_difference, .is_of = with_affine_boundary, .in_percent = true}},
    {"definite_up_to_deformation", &M::definite_up_to_deformation, "definite up to", "",
     "deformation (load fraction times the whole one, in torsion an angle) up to "
     "which the states reached had a positive definite tangent, where that was lost "
     "on the way",
     {.is_of = with_moved_plate}},
    {"critical_wavelength", &M::critical_wavelength, "critical wavelength", "",
     "of solver limit: wavelength of the mode that becomes unstable, in edges between "
     "neighbouring nodes, along the direction in which it is shortest; below 4 it is "
     "a wrinkle, else it buckles",
     {.compared = by_difference}},
    {"mean_deviation", &M::mean_deviation, "mean deviation", "m",
     "mean distance between nodes of this solution and the reference's",
     {.compared = is_deviation}},
    {"max_deviation", &M::max_deviation, "largest deviation", "m",
     "largest such distance",
     {.compared = is_deviation}},
    {"middle_layer_deviation", &M::middle_layer_deviation, "middle-layer deviation", "m",
     "mean distance over the nodes at half height (the thesis's measure); of regular "
     "grids of even cell counts only",
     {.compared = is_deviation}},
    {"deviation_l2_relative", &M::deviation_l2_relative, "deviation L2", "",
     "volume-weighted root mean square of that distance over the nodes with a free "
     "component, divided by the largest displacement imposed on the way (bending: by "
     "the reference's tip deflection; traction: by its face displacement)",
     {.compared = is_deviation, .in_percent = true}},
    {"deviation_max_relative", &M::deviation_max_relative,
     "largest relative deviation", "",
     "largest such distance over the same nodes, divided by the same",
     {.compared = is_deviation, .in_percent = true}},
    {"cell_volume_ratio_rms_difference", &M::cell_volume_ratio_rms_difference,
     "difference of the cells' V/V0", "",
     "volume-weighted root mean square of the cells' V/V0 less the reference's",
     {.compared = is_deviation}},
    {"reference_order", &M::reference_order, "order of the reference", "",
     "order that the displacements of a converged reference show; none if they show "
     "none",
     {.compared = is_deviation}},
    {"reference_bar", &M::reference_bar, "error bound of the reference", "m",
     "how far a converged reference may be off, mean over the nodes",
     {.compared = is_deviation}},
    {"reference_bar_l2_relative", &M::reference_bar_l2_relative,
     "relative error bound of the reference", "",
     "the same as deviation_l2_relative is taken, root mean square and divided",
     {.compared = is_deviation, .in_percent = true}},
    {"tip_deflection", &M::tip_deflection, "tip deflection", "m",
     "displacement of the end face's centre along gravity",
     {.is_of = of_beam, .along_last_load = true}},
    {"tip_euler_bernoulli", &M::tip_euler_bernoulli, "tip by Euler and Bernoulli", "m",
     "the tip by Euler and Bernoulli's theory",
     {.compared = never, .is_of = of_beam}},
    {"tip_timoshenko", &M::tip_timoshenko, "tip by Timoshenko", "m",
     "the tip by Timoshenko's theory",
     {.compared = never, .is_of = of_beam}},
    {"tip_elastica", &M::tip_elastica, "tip by the elastica", "m",
     "the tip by the elastica, of large rotations",
     {.compared = never, .is_of = of_beam}},
    {"centre_line_euler_bernoulli", &M::centre_line_euler_bernoulli,
     "centre line off Euler and Bernoulli", "m",
     "largest distance between nodes of the centre line and that theory's points, "
     "across the plane of bending too; of regular grids of even counts only",
     {.compared = by_difference, .is_of = of_beam}},
    {"centre_line_timoshenko", &M::centre_line_timoshenko,
     "centre line off Timoshenko", "m",
     "the same, Timoshenko's",
     {.compared = by_difference, .is_of = of_beam}},
    {"centre_line_elastica", &M::centre_line_elastica,
     "centre line off the elastica", "m",
     "the same, the elastica's",
     {.compared = by_difference, .is_of = of_beam}},
    {"strain_energy", &M::strain_energy, "strain energy", "J",
     "strain energy; none of a measured result"},
    {"kinetic_energy", &M::kinetic_energy, "kinetic energy", "J",
     "kinetic energy at the end of a motion"},
    {"transit_count", &M::transit_count, "transits of a pressure wave", "",
     "how often a pressure wave runs through the body's height during a motion, "
     "duration sqrt((lambda + 2 mu)/rho)/H; with few of them its end is not what rest "
     "would be",
     {.compared = never}},
    {"wall_s", &M::wall_s, "case time", "s",
     "wall-clock time of the solution and its own measures",
     {.is_time = true}},
    {"solve_wall_s", &M::solve_wall_s, "solution time", "s",
     "wall-clock time of the solution alone",
     {.is_time = true}}};
// clang-format on

}  // namespace measure_table

/// Every measure, in the order of reports. A new one is a member of Measures, an entry of
/// this table and what computes it.
inline constexpr std::span<const Measure> measure_list = measure_table::table;

/// Calls visit(measure, value) for every measure, const or mutable, in the order of
/// reports.
template <class SomeMeasures, class Visit>
void for_each_measure(SomeMeasures& measures, Visit&& visit) {
  for (const Measure& measure : measure_list)
    std::visit([&](const auto member) { visit(measure, measures.*member); },
               measure.member);
}

/// The measure of that name; nullptr where there is none.
const Measure* find_measure(std::string_view name);

/// The unit in which people read the measure, "%" or its own; and the factor from its own
/// unit to that.
std::string_view shown_unit(const Measure& measure);
double shown_factor(const Measure& measure);

/// The measure's label with the unit in which people read it: "volume change [%]",
/// "least V/V0".
std::string heading_of(const Measure& measure);

/// How many numbers the measure is made of: 1, 3 for a vector, 9 for a matrix.
std::size_t component_count(const Measure& measure);

}  // namespace springcheck
