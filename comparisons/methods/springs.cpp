#include <algorithm>
#include <iterator>

#include "comparisons/methods/families.hpp"
#include "comparisons/methods/spring_method.hpp"

namespace springcheck {
namespace {

using fem_reference::Springs;

const std::vector<CellType> any_cells{all_cell_types.begin(), all_cell_types.end()},
    hexahedra{CellType::hexahedron}, tetrahedra{CellType::tetrahedron};

constexpr const char* virtual_source =
    "own; cells of mean gradient as Flanagan and Belytschko 1981, averages around "
    "nodes as Bonet and Burton 1998, springs along directions as microplane models "
    "(Carol, Jirasek and Bazant 2004)";

// Times of a simulated second [s]: kernels .037 and .042, that of mss-affine .1, plain
// loops .66, those of 25 isochoric springs 1.5; measured with what is done once, about
// half of the first.
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

/// Models of springs on any cells, whose kernels, of these precisions, are for hexahedra.
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

/// The thesis's springs on grids of hexahedra.
std::vector<Method> thesis_lattices() {
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
                      .charted = lattice_models})};
}

/// Springs on the edges and diagonals of hexahedra that follow another law, or none.
std::vector<Method> further_lattices() {
  using enum mss::SpringModel;
  return {
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
           .beside_printed = true})};
}

/// Virtual springs, on any cells.
std::vector<Method> virtual_springs() {
  using enum mss::SpringModel;
  return {
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
                  // In squared lengths all isotropic springs are the same law.
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
                 2.8)};
}

/// Springs on the edges of tetrahedra, and the user's own.
std::vector<Method> edge_springs() {
  using enum mss::SpringModel;
  return {
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

}  // namespace

std::vector<Method> spring_methods() {
  std::vector<Method> all;
  for (auto methods :
       {thesis_lattices(), further_lattices(), virtual_springs(), edge_springs()})
    std::ranges::move(methods, std::back_inserter(all));
  return all;
}

}  // namespace springcheck
