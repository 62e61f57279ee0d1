// Every setting, each declared here and nowhere else, in the order of reading.

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/settings/setting_access.hpp"
#include "comparisons/settings/setting_readers.hpp"
#include "tissue/maxwell_fit.hpp"

namespace springcheck {
namespace {

using namespace setting_table;
using enum InCharts;
using C = CaseSettings;
using Network = mss::NetworkSettings;
using statics::Search;

constexpr SettingGroup what_runs{"what is compared", "method"}, body{"body", "scene"},
    material{"material", "material"}, load{"load", "scene"},
    of_lattices{"springs", "method"}, of_elements{"finite elements", "method"},
    solution{"solution", "solver"}, motion{"through time", "dynamics"},
    living{"tissue", "tissue"};
constexpr int durations = 1, laws_of_tissue = 2;  // settings that replace each other

// Key, group, what charts do with it, who reads it, how it is read and told, its default,
// its help; and what else there is to say.
// clang-format off
constexpr Setting table[] = {
    {"test", what_runs, taken, all, value<named<Test>, &C::test>, {},
     "compression, tension, shearing, torsion, bending, uniaxial, traction or affine",
     {.standing = Standing::scene_file, .needed = "the name of a test"}},
    {"method", what_runs, chosen, all,
     telling(in_run<method_choices, &RunSettings::methods>, method_told), {},
     "methods, see 'springcheck list methods', or METHOD:ELEMENT",
     {.standing = Standing::plan, .needed = "a list of methods"}},
    {"reference", what_runs, chosen, all, {read_reference, {}, texts}, {},
     "METHOD[:ELEMENT|:SOLVER][@CELLS|@converged] that deviations are measured against, "
     "at the load with which a path ends",
     {.standing = Standing::plan, .default_text =
      "on the same mesh: fem-hooke:q1-sri up to a deformation of .02, "
      "fem-stvk:q1-sri above, in tests without a deformation and where another case of "
      "a sweep deforms by more"}},
    {"expect", what_runs, chosen, all, in_run<statuses_of, &RunSettings::expect>, "ok",
     "statuses that end a run of one method with exit status 0",
     {.standing = Standing::scene_file}},

    {"body", body, taken, all, in_body<named<BodyShape>, &Body::shape>, "block",
     "block, kidney or disc", {.standing = Standing::scene_file, .instead = "mesh"}},
    {"mesh", body, unused, all, {read_mesh, {}, text}, {},
     "a .msh file (gmsh 2.2 or 4.1) in place of the block"},
    {"mesh-unit", body, unused, all, untold_in_body<named<MeshUnit>, &Body::unit>, "m",
     "length unit of the .msh file: m, cm or mm", {.beside = "mesh"}},
    {"fixed", body, unused, of_lower_plates, in_body<&Given::text, &Body::fixed>,
     "bottom",
     "name of the .msh file's surface on the lower, fixed plate", {.beside = "mesh"}},
    {"moved", body, unused, of_upper_plates, in_body<&Given::text, &Body::moved>, "top",
     "name of the one on the upper plate, which is moved or loaded", {.beside = "mesh"}},
    {"size", body, taken, of_cells, in_block<size_of, &Block::size>, {},
     "size of the block along x,y,z [m]",
     {.dimension = Dimension::length, .instead = "mesh", .needed = "three lengths [m]",
      .is_needed = has_body_cells}},
    {"cells", body, chosen, of_cells, in_block<cells_of, &Block::cells>, {},
     "number of cells along x,y,z",
     {.label = "cells along x, y, z", .instead = "mesh", .needed = "three counts",
      .is_needed = has_body_cells}},
    {"cell-type", body, chosen, of_cells, in_block<named<CellPattern>, &Block::pattern>,
     "hexahedron",
     "how the block is cut: hexahedron, tetrahedron, prism, pyramid, mixed or another "
     "of 'springcheck list cell-types'",
     {.usual_axis = "hexahedron,tetrahedron,prism,pyramid,mixed", .instead = "mesh"}},
    {"distortion", body, chosen, of_blocks, in_block<not_negative_of, &Block::distortion>,
     "0",
     "how far nodes inside the block are moved along each axis, as a fraction of the "
     "cell edge",
     {.dimension = Dimension::fraction, .label = "distortion over the cell edge",
      .usual_axis = "0:0.3:7", .instead = "mesh"}},
    {"cut", body, taken, all, {read_cuts, cuts_told, list_of_tables}, {},
     "what is cut before the body is loaded: split, or remove cells, along a plane, box, "
     "cylinder or polyline, as split,plane=0,0,1,0.025,within=0,0,0,0.025,0.05,0.05; in "
     "scene files a [[cut]] each", {.has = leaves_surfaces_free}},
    {"seed", body, taken, of_chance, {read_seed, seed_told, type_of<int>()}, "1",
     "of distorted and mixed meshes, of noise, and of the choice between equal "
     "directions out of an unstable state", {.counts = true}},

    {"nu", material, taken, all, in_material<poisson_ratio_of, &Material::poisson_ratio>,
     {},
     "Poisson ratio, in (-1, 0.5)",
     {.label = "Poisson's ratio",
      .usual_axis = "0,0.05,0.1,0.15,0.2,0.25,0.3,0.35,0.4,0.45,0.49,0.499",
      .needed = "a number in (-1, 0.5)"}},
    {"young", material, taken, of_elastic,
     in_material<&Given::positive_number, &Material::young_modulus>, {},
     "Young's modulus [Pa]",
     {.dimension = Dimension::pressure, .label = "Young's modulus",
      .needed = "Young's modulus [Pa]", .is_needed = has_elastic_methods}},
    {"density", material, taken, all,
     in_material<&Given::positive_number, &Material::density>, {},
     "mass density [kg/m^3]",
     {.dimension = Dimension::density, .needed = "a density [kg/m^3]"}},

    {"deformation", load, taken, all, value<deformation_of, &C::deformation>, {},
     "strain, or angle of torsion [rad]; '5%' and '45deg' are understood; in uniaxial "
     "positive pulls and negative presses",
     {.dimension = Dimension::deformation, .usual_axis = "5%:60%:12", .has = deforms,
      .needed = "a strain or angle"}},
    {"gravity", load, taken, all, value<gravity_of, &C::gravity>, {},
     "acceleration in bending [m/s^2]",
     {.dimension = Dimension::acceleration,
      .standing = Standing::scene_file, .has = in_tests<Test::bending>,
      .needed = "an acceleration [m/s^2]"}},
    {"plates", load, unused, all, value<named<PlateContact>, &C::plates>, "glued",
     "how the lower plate holds in traction: glued or sliding",
     {.has = in_tests<Test::traction>}},
    {"traction", load, unused, all, value<traction_of, &C::traction>, {},
     "force per undeformed area x,y,z on the upper face in traction [Pa]",
     {.dimension = Dimension::pressure,
      .has = in_tests<Test::traction>, .needed = "a force per area [Pa]"}},
    {"gradient", load, unused, all, value<gradient_of, &C::gradient>, {},
     "displacement gradient of the boundary in affine, nine numbers by rows",
     {.has = in_tests<Test::affine>,
      .needed = "nine numbers, row by row"}},

    {"diagonal-ratio", of_lattices, chosen, of_methods_as_option,
     in_springs<not_negative_of, &Network::diagonal_ratio>, "1",
     "A = k_f/k_c of springs or of a continuum's lattice",
     {.label = "A = k_f/k_c, face over inner diagonals",
      .usual_axis = "0.01,0.03,0.1,0.3,1,3,10,30,100", .variant = ", A = {}"}},
    {"stiffness-form", of_lattices, chosen, of_methods_as_option,
     in_springs<named<mss::StiffnessForm>, &Network::stiffness_form>, "mu",
     "constants of springs or of a continuum's lattice from mu or, as Eq. 5.12 prints, "
     "E", {.variant = ", {}-form"}},
    {"stiffness", of_lattices, chosen, of_methods_alone,
     {read_stiffness, stiffness_told, so_many_numbers<3>}, {},
     "KE,KF,KC: lattice values of edge, face-diagonal and inner-diagonal springs at the "
     "scene's cell size [N/m]",
     {.dimension = Dimension::stiffness, .needed = "KE,KF,KC [N/m]"}},
    {"kappa", of_lattices, chosen, of_methods_alone, {read_kappa, kappa_told, number}, "0",
     "modulus of the volume correction [Pa]; 0: none",
     {.dimension = Dimension::pressure}},
    {"spring-strain", of_lattices, chosen, of_methods_as_option,
     in_springs<named<mss::StrainMeasure>, &Network::strain_measure>, "engineering",
     "strain that the energy of springs, or of a continuum's lattice, is quadratic in: "
     "engineering, green (squared lengths) or logarithmic; or hencky, a function that "
     "follows Hencky's law", {.variant = ", {}"}},
    {"directions", of_lattices, chosen, of_methods_as_option,
     in_digits<mss::Axes>(in_springs<numbered<mss::Axes>, &Network::axes>), "16",
     "of virtual springs in a cell, or in its continuum: 6, 16 or 25",
     {.counts = true, .variant = ", {} directions"}},
    {"correction", of_lattices, chosen, of_methods_alone,
     in_springs<named<mss::VolumeCorrection>, &Network::volume_correction>, "on",
     "volume correction: on, off", {.variant = ", no correction"}},

    {"element", of_elements, chosen, of_methods,
     in_elements<named<ElementName>, &ElementSettings::element>, "q1-sri",
     "finite element: q1, q1-sri, q1-nodal, or q2 on hexahedra"},
    {"lattice", of_elements, chosen, of_methods_alone,
     in_elements<named<LatticeName>, &ElementSettings::lattice>,
     "mss-cf",
     "springs whose continuum it is:", {.variant = " ({})"}},
    {"lattice-direction", of_elements, chosen, of_methods_alone,
     in_digits<fem_reference::LatticeDirection>(
         in_elements<numbered<fem_reference::LatticeDirection>,
                     &ElementSettings::lattice_direction>), "100",
     "direction of the lattice along z: 100, 110, 111", {.counts = true}},

    {"solver", solution, chosen, of_solvers,
     telling(value<named<Solver>, &C::solver>, solver_told), {},
     "static, limit (static, to where the path loses its stability or a cell is turned "
     "inside out), or dynamics by explicit (Euler), semi-implicit (Euler), verlet or "
     "implicit (Euler) of spring methods; fem-explicit methods are never static or "
     "implicit, other finite elements static or limit",
     {.default_text = "static; of fem-explicit methods semi-implicit"}},
    {"linear-solver", solution, chosen, of_methods_without_inertia,
     value<named<statics::LinearSolver>, &C::search, &Search::linear_solver>, "auto",
     "of the linear systems of static solutions: auto (by size), direct, or "
     "conjugate-gradients by themselves or with multigrid"},
    {"noise", solution, chosen, of_methods_at_rest,
     value<not_negative_of, &C::search, &Search::noise>, "0",
     "of static solutions: noise on the nodes' positions, in cell edges, from which they "
     "are solved again; 0: none", {.label = "noise over the cell edge"}},

    {"dt", motion, chosen, of_steps,
     telling(in_motion<time_step_of, &Dynamics::time_step>, time_step_told), "auto",
     "time step [s], or auto: 0.9 of the stability limit, followed as the body deforms",
     {.dimension = Dimension::time, .label = "time step"}},
    {"dt-ratio", motion, chosen, of_usual_steps,
     in_motion<&Given::positive_number, &Dynamics::step_ratio>, "0.9",
     "of dt = auto: the step over the stability limit; above 1 to see what becomes of "
     "it",
     {.label = "step over its stability limit", .usual_axis = "0.8:1.2:9"}},
    {"force-dt", motion, chosen, of_steps,
     in_motion<&Given::truth, &Dynamics::force_time_step>, "false",
     "run even with a time step above the stability limit"},
    {"duration", motion, taken, of_time,
     in_motion<&Given::positive_number, &Dynamics::duration>, "10",
     "time over which the load grows in dynamics [s]",
     {.dimension = Dimension::time, .label = "duration of the load",
      .replaces = durations}},
    {"rate", motion, taken, of_time, {read_rate, {}, number}, {},
     "of the deformation or the largest component of a gradient, in place of a duration "
     "[1/s]: it is reached in deformation/rate",
     {.dimension = Dimension::rate, .replaces = durations}},
    {"load-times", motion, unused, of_points,
     {read_load_times, load_points<&dynamics::LoadPoint::time>, numbers}, {},
     "times [s], ascending, of load-fractions; in place of a duration",
     {.dimension = Dimension::time, .beside = "load-fractions",
      .replaces = durations}},
    {"load-fractions", motion, unused, of_points,
     {read_fractions, load_points<&dynamics::LoadPoint::fraction>, numbers}, {},
     "of the load at those times, straight between them and from 0 at rest: '0,1' after "
     "'1,2' holds still for a second", {.beside = "load-times"}},
    {"angular-frequency", motion, unused, of_swings,
     {read_frequency, frequency_told, number}, {},
     "of a load that swings, sin(omega t) [rad/s]; in place of a duration",
     {.dimension = Dimension::angular_frequency, .replaces = durations}},
    {"cycles", motion, unused, of_swings, {read_cycles, cycles_told, number}, "5",
     "of that load, also parts of one", {.beside = "angular-frequency"}},
    {"damping", motion, taken, of_dashpots,
     in_motion<not_negative_of, &Dynamics::damping_ratio>, "0.05",
     "in dynamics, fraction of critical: dashpots of springs, drag of finite elements",
     {.dimension = Dimension::fraction, .label = "damping ratio ζ of each spring",
      .usual_axis = "0,0.01,0.02,0.05,0.1,0.2,0.5,1"}},
    {"precision", motion, chosen, of_dashpots,
     in_motion<named<mss::Precision>, &Dynamics::precision>, "double",
     "of explicit steps: double or float"},
    {"history", motion, chosen, of_histories,
     telling(in_motion<count_of<0, 1'000'000>, &Dynamics::history>, history_told), "0",
     "samples of deformation, volume, plate force and torque, energies and what answers "
     "the load at equal distances in time, on each straight piece of the load; in "
     "dynamics and of tissue; 0: none", {.counts = true}},

    {"organ", living, unused, of_methods_alone, {read_organ, {}, type_of<tissue::Organ>()}, {},
     "liver, kidney or spleen: Golec 2018's law of it, for methods of tissue",
     {.replaces = laws_of_tissue}},
    {"law", living, unused, of_methods_alone, {read_law, law_told, so_many_numbers<4>}, {},
     "K,n,GAMMA_LIM,p of tissue's bi-power law, but for mss-thesis-tissue: K [Pa s^n], "
     "others without unit",
     {.replaces = laws_of_tissue,
      .needed = "K,n,GAMMA_LIM,p of tissue, or an organ"}},
    {"branches", living, unused, of_methods_alone,
     value<count_of<2, tissue::most_branches>, &C::tissue, &Tissue::branches>, "6",
     "Maxwell branches of tissue, 2 to 32"},
    {"time-steps", living, unused, of_tissue_at_rest,
     {read_time_steps, time_steps_told,
      type_of<std::optional<int>>()}, "auto",
     "of tissue's static solver, on each straight piece of the load; auto: 50, of a "
     "load that swings 1 on each 64th of a cycle"}};
// clang-format on

}  // namespace

std::span<const Setting> all_settings() {
  return table;
}

const Setting* find_setting(std::string_view key) {
  const auto found = std::ranges::find(table, key, &Setting::key);
  return found == std::end(table) ? nullptr : found;
}

bool is_reader(const CaseSettings& settings, const Setting& setting) {
  const Readers& readers = setting.readers;
  return (!readers.of_methods || reads(settings, setting.key)) &&
         (readers.is_one == nullptr || readers.is_one(settings));
}

bool reads(const CaseSettings& settings, const Setting& setting) {
  return (setting.has == nullptr || setting.has(settings.test)) &&
         is_reader(settings, setting);
}

/// Methods whose entries list the setting, and the continuum of lattices that do.
static std::vector<std::string> own_readers(const Setting& setting) {
  std::vector<std::string> names;
  for (const Method& method : methods())
    if (reads(method, setting.key)) names.push_back(method.name);
  if (std::ranges::any_of(lattices(), [&](const LatticeName& lattice) {
        return std::ranges::count(lattice.reads, setting.key) > 0;
      }))
    for (const Method& method : methods())
      if (reads(method, "lattice") && !reads(method, setting.key))
        names.push_back(method.name + " of such a lattice");
  return names;
}

std::string without_readers(const Setting& setting) {
  if (!setting.readers.without.empty()) return std::string(setting.readers.without);
  return fmt::format("without {} as method or reference",
                     fmt::join(own_readers(setting), " or "));
}

std::string help_of(const Setting& setting) {
  const std::string_view usual =
      setting.default_text.empty() ? setting.otherwise : setting.default_text;
  std::string help(setting.help);
  if (help.ends_with(':'))
    help += fmt::format(" {}", fmt::join(setting.access.type.names(), ", "));
  const auto readers = own_readers(setting);
  constexpr std::size_t few = 4;
  if (setting.readers.of_methods && readers.size() <= few)
    help += fmt::format("; of {}", fmt::join(readers, ", "));
  return usual.empty() || setting.access.type.kind == ValueType::Kind::truth
             ? help
             : fmt::format("{} (default {})", help, usual);
}

std::string variant_of(const Setting& setting, const std::string& value) {
  if (setting.variant.empty() || value.empty() || value == setting.otherwise) return {};
  return fmt::format(fmt::runtime(setting.variant), value);
}

std::string variant_label(const CaseSettings& settings) {
  std::string name = label(settings);
  for (const Setting& setting : all_settings()) {
    if (setting.variant.empty() || !reads(settings, setting)) continue;
    const nlohmann::json value = setting.access.told(settings);
    if (value.is_string())
      name += variant_of(setting, value.get<std::string>());
    else if (value.is_number())
      name += variant_of(setting, fmt::format("{:g}", value.get<double>()));
  }
  return name;
}

std::vector<std::string_view> setting_keys() {
  std::vector<std::string_view> keys;
  for (const Setting& setting : table) keys.push_back(setting.key);
  return keys;
}

std::vector<std::string_view> option_keys() {
  std::vector<std::string_view> keys;
  for (const Setting& setting : table)
    if (is_option(setting)) keys.push_back(setting.key);
  return keys;
}

}  // namespace springcheck
