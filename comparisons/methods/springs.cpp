#include "comparisons/methods/families.hpp"

#include <algorithm>
#include <memory>

#include "comparisons/cases/case.hpp"
#include "comparisons/methods/protocol.hpp"
#include "mss/networks/spring_model_table.hpp"
#include "mss/solve.hpp"

namespace springcheck {
namespace {

using fem_reference::Springs;

const std::vector<CellType> any_cells{all_cell_types.begin(), all_cell_types.end()},
    hexahedra{CellType::hexahedron}, tetrahedra{CellType::tetrahedron};

mss::NetworkSettings network_settings(const CaseSettings& settings,
                                      mss::SpringModel model) {
  mss::NetworkSettings springs = springs_of(settings, settings.method.fixed);
  springs.model = model;
  return springs;
}

std::optional<mss::DynamicsSettings> motion_settings(const CaseSettings& settings,
                                                     int threads) {
  if (!goes_through_time(settings)) return std::nullopt;
  return mss::DynamicsSettings{.protocol = protocol_of(settings),
                               .damping_ratio = settings.dynamics.damping_ratio,
                               .precision = settings.dynamics.precision,
                               .threads = threads};
}

std::string words_of(mss::CellShapes shapes) {
  switch (shapes) {
    case mss::CellShapes::any:
      return "cells of any shape";
    case mss::CellShapes::tetrahedra:
      return "tetrahedra of any shape";
    case mss::CellShapes::cubes:
      return "cubes";
    case mss::CellShapes::boxes:
      break;
  }
  return "cubes, and boxes that springs of no negative stiffness make isotropic, on "
         "which A has no effect";
}

constexpr const char* virtual_source =
    "own; cells of mean gradient as Flanagan and Belytschko 1981, averages around "
    "nodes as Bonet and Burton 1998, springs along directions as microplane models "
    "(Carol, Jirasek and Bazant 2004)";

/// 3 x 3 blocks with 26 neighbours and the own one.
constexpr double entries_of_neighbours = 9 * 27;

/// Of memory for each cell. Peaks of `run compression` by multigrid: 779 MB at 30^3 cells
/// of mss-cf, 5047 MB at 60^3; of mss-affine at nu = .4 1740 MB at 30^3, 3931 MB at 40^3.
constexpr double multigrid_bytes = 20e3;

/// A method with what all of springs have. Of a solution's systems the coupling is that
/// above nu = 1/4.
Method of_springs(mss::SpringModel springs, Method own, double coupling = 1) {
  own.family = Family::springs;
  if (own.lattice) {
    own.lattice->name = own.name;
    own.lattice->reads = own.reads;
    own.lattice->fixed = own.fixed;
  }
  own.covers = words_of(mss::entry_of(springs).cells) + own.covers;
  if (own.fixed.strain != mss::StrainMeasure::hencky &&
      std::ranges::count(own.cells, CellType::hexahedron) > 0)
    own.covers += std::string("; single precision on hexahedra, by explicit steps") +
                  (std::ranges::count(own.reads, "spring-strain") > 0
                       ? ", of engineering and green strain"
                       : "");
  own.reads.insert(own.reads.end(),
                   {"damping", "precision", "linear-solver", "noise", "seed"});
  own.solvers = {Solver::static_equilibrium,  Solver::path_limit, Solver::explicit_euler,
                 Solver::semi_implicit_euler, Solver::verlet,     Solver::implicit_euler};
  own.seconds.at_rest = 0.5;  // .25 to 1.6, most where they wrinkle
  own.solve = [springs](const CaseSettings& settings, const Mesh& mesh,
                        const Scene& scene, int threads,
                        const dynamics::Observers& observers) {
    return mss::solve(mesh, scene,
                      {.network = network_settings(settings, springs),
                       .dynamics = motion_settings(settings, threads),
                       .search = search_of(settings)},
                      observers);
  };
  own.network = [springs](const CaseSettings& settings,
                          const Mesh& mesh) -> std::optional<mss::Network> {
    if (mss::reason_to_refuse(mesh, settings.material, springs)) return std::nullopt;
    return mss::build_network(mesh, settings.material,
                              network_settings(settings, springs));
  };
  own.stepping = [springs](const CaseSettings& settings, const Mesh& mesh,
                           const Scene& scene) -> MakeMotion {
    const auto network = std::make_shared<mss::Network>(
        mss::build_network(mesh, settings.material, network_settings(settings, springs)));
    return [=, &mesh, &scene, protocol = protocol_of(settings),
            dynamics = settings.dynamics](const SteppingOptions& options) {
      return mss::motion_of(
          mesh, scene, *network,
          {.protocol = protocol,
           .damping_ratio = dynamics.damping_ratio,
           .precision = dynamics.precision,
           .threads = options.threads,
           .kernel = options.by_plain_loops ? mss::Kernel::plain : mss::Kernel::fast},
          options.instruction_set);
    };
  };
  own.linear_systems = [coupling](const CaseSettings& settings) -> LinearSystems {
    if (!needs_tangents(settings)) return {};
    const double further = settings.material.poisson_ratio > 0.25 ? coupling : 1;
    return {.kind = linear_systems_of(settings),
            .coupling = further,
            .multigrid_bytes = multigrid_bytes * further,
            .entries_per_node = entries_of_neighbours * further};
  };
  return own;
}

// Of a simulated second: kernels .037 and .042, that of mss-affine .1, plain loops .66,
// of 25 isochoric springs 1.5; measured with what is done once, about half of the first.
constexpr double by_kernels = 0.03, by_affine_kernel = 0.1, by_plain_loops = 0.6,
                 by_isochoric_springs = 1.4;
constexpr Seconds of_lattices{.in_motion = by_kernels, .in_motion_off_grids = by_kernels},
    of_virtual_springs{.in_motion = by_affine_kernel,
                       .in_motion_off_grids = by_plain_loops},
    of_plain_loops{.in_motion = by_plain_loops, .in_motion_off_grids = by_plain_loops},
    of_isochoric_springs{.in_motion = by_isochoric_springs,
                         .in_motion_off_grids = by_isochoric_springs};

constexpr auto double_precision = dynamics::Precision::double_precision,
               single_precision = dynamics::Precision::single_precision;

std::vector<Model> models(std::vector<CellType> at_rest,
                          std::vector<dynamics::Precision> in_motion) {
  std::vector<Model> all;
  for (const CellType cells : at_rest) all.push_back({.cells = cells});
  for (const auto precision : in_motion) all.push_back({.precision = precision});
  return all;
}

const std::vector<Model> lattice_models =
    models({CellType::hexahedron}, {double_precision, single_precision});

/// Of springs on any cells, whose kernels, of the precisions, are for hexahedra.
std::vector<Model> models_on_any_cells(std::vector<dynamics::Precision> in_motion) {
  auto all = models({CellType::hexahedron, CellType::tetrahedron, CellType::prism},
                    std::move(in_motion));
  all.push_back({.cells = CellType::tetrahedron, .precision = double_precision});
  return all;
}

const std::vector<Model> virtual_models =
    models_on_any_cells({double_precision, single_precision});

constexpr std::string_view no_correction = "No volume correction";
constexpr Omission no_face_diagonals{
    .what =
        "No face diagonals: without them the path to the full load stays stable on "
        "these cells (its tangent positive definite)."};

std::string_view at_a_quarter(const Material& material) {
  return material.poisson_ratio == 0.25
             ? "No volume correction: at nu = 1/4 its modulus is zero, and springs alone "
               "have the Poisson ratio."
             : "";
}

}  // namespace

std::vector<Method> spring_methods() {
  using enum mss::SpringModel;
  return {
      of_springs(baudet, {.name = "mss-baudet",
                          .description = "edge and inner-diagonal springs after Baudet",
                          .source = "Golec 2018, chapter 3, after Baudet",
                          .look = {"#CC79A7", "v"},
                          .covers = "; Poisson's ratios above -1/4",
                          .cells = hexahedra,
                          .lattice = LatticeName{.springs = Springs::baudet},
                          .seconds = of_lattices,
                          .charted = models({CellType::hexahedron}, {}),
                          .omits = {{no_correction, "mss-nfd"}, no_face_diagonals}}),
      of_springs(nfd,
                 {.name = "mss-nfd",
                  .description = "edge and inner-diagonal springs with volume correction",
                  .source = "Golec 2018, Eq. 5.12 with A = 0, and 5.36",
                  .look = {"#E69F00", "^"},
                  .reads = {"stiffness-form", "spring-strain"},
                  .cells = hexahedra,
                  .corrects_volume = true,
                  .lattice = LatticeName{.springs = Springs::nfd},
                  .seconds = of_lattices,
                  .charted = lattice_models,
                  .omits = {no_face_diagonals}}),
      of_springs(
          fd, {.name = "mss-fd",
               .description = "all springs without correction: right at nu = 0.25 only",
               .source = "Golec 2018, Eq. 5.11 and 5.12; of boxes: own",
               .look = {"#56B4E9", "<"},
               .reads = {"diagonal-ratio", "stiffness-form", "spring-strain"},
               .cells = hexahedra,
               .own_poisson_ratio = 0.25,
               .lattice = LatticeName{.springs = Springs::fd},
               .seconds = of_lattices,
               .charted = lattice_models,
               .omits = {{no_correction, "mss-cf", at_a_quarter}}}),
      of_springs(cf, {.name = "mss-cf",
                      .description = "all springs with volume correction (Golec 2018)",
                      .source = "Golec 2018, Eq. 5.11, 5.12 and 5.36; of boxes: own",
                      .look = {"#0072B2", "o"},
                      .reads = {"diagonal-ratio", "stiffness-form", "spring-strain"},
                      .cells = hexahedra,
                      .corrects_volume = true,
                      .foremost = 1,
                      .of_thesis = true,
                      .lattice = LatticeName{.springs = Springs::cf},
                      .seconds = of_lattices,
                      .charted = lattice_models}),
      of_springs(cf, {.name = "mss-stvk",
                      .description = "mss-cf in squared lengths (spring-strain = green): "
                                     "St-Venant-Kirchhoff's law",
                      .source = "springs as Delingette 2008; constants as mss-cf",
                      .same_law_as = "fem-stvk",
                      .look = {"#FF8C42", "o"},
                      .reads = {"diagonal-ratio", "stiffness-form"},
                      .cells = hexahedra,
                      .corrects_volume = true,
                      .foremost = 3,
                      .fixed = {.strain = mss::StrainMeasure::green},
                      .lattice = LatticeName{.springs = Springs::cf},
                      .seconds = of_lattices,
                      .charted = lattice_models,
                      .beside_printed = true}),
      of_springs(
          cf, {.name = "mss-hencky",
               .description = "mss-cf of springs that follow Hencky's law as far as a "
                              "lattice's can (spring-strain = hencky), A = 16/9",
               .source = "own; constants as mss-cf",
               .same_law_as = "fem-hencky",
               .look = {"#7B2CBF", "o"},
               .reads = {"stiffness-form"},
               .cells = hexahedra,
               .corrects_volume = true,
               .foremost = 4,
               .fixed = {.strain = mss::StrainMeasure::hencky, .diagonal_ratio = 16. / 9},
               .lattice = LatticeName{.springs = Springs::cf},
               .seconds = of_plain_loops,
               .charted = models({CellType::hexahedron}, {double_precision}),
               .beside_printed = true}),
      of_springs(
          uniform,
          {.name = "mss-uniform",
           .description = "all springs of a cell of one stiffness: Young's modulus along "
                          "the axes, nu = 5/19 whatever is asked for",
           .source = "own",
           .look = {"#E7298A", "d"},
           .reads = {"spring-strain"},
           .cells = hexahedra,
           .own_poisson_ratio = 5. / 19,
           .seconds = of_lattices,
           .charted = lattice_models,
           .omits = {{no_correction, "mss-cf"}},
           .beside_printed = true}),
      // It couples a node with its neighbours' neighbours where its volume correction
      // acts on nodal patches. Peaks at 10^3 and 20^3 cubes: 221 and 714 MB,
      // mss-cf's 188 and 432.
      of_springs(affine,
                 {.name = "mss-affine",
                  .description = "virtual springs, on any cells of any shape",
                  .source = virtual_source,
                  .look = {"#009E73", "D"},
                  .reads = {"spring-strain", "directions"},
                  .cells = any_cells,
                  .corrects_volume = true,
                  .foremost = 2,
                  .lattice = LatticeName{.springs = Springs::affine, .of_cubes = false},
                  .seconds = of_virtual_springs,
                  .charted = virtual_models},
                 2.8),
      of_springs(affine,
                 {.name = "mss-affine-stvk",
                  .description = "mss-affine in squared lengths (spring-strain = green): "
                                 "St-Venant-Kirchhoff's law, on any cells",
                  .source = virtual_source,
                  .same_law_as = "fem-stvk",
                  .look = {"#8F3D00", "D"},
                  .cells = any_cells,
                  .corrects_volume = true,
                  .foremost = 5,
                  // In squared lengths any that are isotropic are the same law.
                  .fixed = {.strain = mss::StrainMeasure::green, .axes = mss::Axes::six},
                  .lattice = LatticeName{.springs = Springs::affine, .of_cubes = false},
                  .seconds = of_virtual_springs,
                  .charted = virtual_models,
                  .beside_printed = true},
                 2.8),
      of_springs(affine,
                 {.name = "mss-affine-hencky",
                  .description = "mss-affine of springs that see a cell's shape alone "
                                 "(spring-strain = hencky, 25 directions): Hencky's law "
                                 "to third order, on any cells",
                  .source = virtual_source,
                  .same_law_as = "fem-hencky",
                  .look = {"#332288", "D"},
                  .cells = any_cells,
                  .corrects_volume = true,
                  .foremost = 6,
                  .fixed = {.strain = mss::StrainMeasure::hencky,
                            .axes = mss::Axes::twenty_five},
                  .lattice = LatticeName{.springs = Springs::affine, .of_cubes = false},
                  .seconds = of_isochoric_springs,
                  .charted = models_on_any_cells({double_precision}),
                  .beside_printed = true},
                 2.8),
      of_springs(
          vangelder,
          {.name = "mss-vangelder",
           .description = "edges of tetrahedra after Van Gelder (option --correction)",
           .source = "Van Gelder 1998, Approximate simulation of elastic membranes by "
                     "triangulated spring meshes",
           .look = {"#B8A600", ">"},
           .reads = {"correction"},
           .cells = tetrahedra,
           .seconds = of_plain_loops,
           .charted = models(tetrahedra, {})}),
      of_springs(lloyd,
                 {.name = "mss-lloyd",
                  .description = "edges of tetrahedra after Lloyd (option --correction)",
                  .source = "Lloyd, Szekely and Harders 2007, Identification of spring "
                            "parameters for deformable object simulation",
                  .look = {"#8B5A2B", "p"},
                  .reads = {"correction"},
                  .cells = tetrahedra,
                  .seconds = of_plain_loops,
                  .charted = models(tetrahedra, {})}),
      of_springs(custom,
                 {.name = "mss-custom",
                  .description = "springs and volume correction of your own (options "
                                 "--stiffness, --kappa)",
                  .source = "the user's constants",
                  .look = {"#1F3A5F", "d"},
                  .reads = {"stiffness", "kappa", "spring-strain"},
                  .cells = hexahedra,
                  .belongs_to_cells = true,
                  .seconds = of_lattices})};
}

}  // namespace springcheck
