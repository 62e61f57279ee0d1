#include "comparisons/methods/families.hpp"

#include <numbers>

#include "comparisons/cases/case.hpp"
#include "comparisons/methods/protocol.hpp"
#include "fem_reference/solve.hpp"

namespace springcheck {
namespace {

using fem_reference::Law;

/// A law with what all have.
Method of_elements(Law law, Method own) {
  own.family = Family::finite_elements;
  if (own.description.empty())
    own.description = "finite elements, " + std::string(own.law);
  own.reads.insert(own.reads.end(), {"element", "linear-solver", "noise", "seed"});
  own.covers =
      "cells of any shape, q2 hexahedra alone; bodies at rest, by solver limit where a "
      "case names that" +
      own.covers;
  own.cells = {all_cell_types.begin(), all_cell_types.end()};
  own.solvers = {Solver::static_equilibrium, Solver::path_limit};
  own.follows_solver = false;
  own.solve = [law](const CaseSettings& settings, const Mesh& mesh, const Scene& scene,
                    int /*threads*/, const dynamics::Observers& /*observers*/) {
    return fem_reference::solve(mesh, scene, elements_of(settings, law),
                                search_of(settings));
  };
  own.linear_systems = [](const CaseSettings& settings) -> LinearSystems {
    return {.kind = linear_systems_of(settings),
            .coupling = settings.elements.element.coupling,
            .multigrid_bytes = settings.elements.element.multigrid_bytes,
            .entries_per_node = settings.elements.element.entries_per_node};
  };
  return own;
}

constexpr Seconds of_linear{.at_rest = 0.1}, of_others{.at_rest = 0.6};  // .3 to .7

fem_reference::SpringStrain strain_of(mss::StrainMeasure measure) {
  using fem_reference::SpringStrain;
  switch (measure) {
    case mss::StrainMeasure::green:
      return SpringStrain::green;
    case mss::StrainMeasure::logarithmic:
      return SpringStrain::logarithmic;
    case mss::StrainMeasure::hencky:
      return SpringStrain::hencky;
    case mss::StrainMeasure::engineering:
      break;
  }
  return SpringStrain::engineering;
}

constexpr Omission no_small_strain{"Not Hooke's law", "fem-hooke"};

}  // namespace

std::vector<ElementName> finite_elements() {
  using fem_reference::Element;
  constexpr Omission no_quadratic{"No quadratic elements", "q2"};
  // Peaks of `run compression` by multigrid, Hooke and others alike: 721 MB at 30^3 cells
  // of q1 and q1-sri, 4621 MB at 60^3; 2263 MB at 20^3 cells of q2, which are 40^3
  // divisions; 618 MB at 20^3 cells of q1-nodal, 1702 MB at 30^3. Factors: q1-nodal 810
  // MB at 20^3 and 2520 MB at 28^3, where q1-sri takes 366 and 869. Entries: 3 x 3 blocks
  // of 27 nodes, those of q2 of 64 on average.
  constexpr double of_q1 = 9 * 27, of_q1_nodal = 9 * 125, of_q2 = 9 * 64;
  return {{.name = "q1",
           .element = Element::q1,
           .description = "linear or trilinear, full integration: locks near nu = 0.5",
           .order = 2,
           .divisions = 1,
           .multigrid_bytes = 18e3,
           .entries_per_node = of_q1,
           .omits = {{"No reduced integration", "q1-sri"}, no_quadratic},
           .locks = true},
          {.name = "q1-sri",
           .element = Element::q1_sri,
           .description = "the same, volumetric part from the cell's mean (selective "
                          "reduced integration; on tetrahedra it is q1)",
           .order = 2,
           .divisions = 1,
           .multigrid_bytes = 18e3,
           .entries_per_node = of_q1,
           .omits = {no_quadratic}},
          {.name = "q1-nodal",
           .element = Element::q1_nodal,
           .description = "the same, volumetric part from means around the nodes, on "
                          "tetrahedra nearly all of the rest too: for cells of any type "
                          "near nu = 0.5",
           .order = 2,
           .divisions = 1,
           .multigrid_bytes = 55e3,
           .entries_per_node = of_q1_nodal,
           .coupling = 3.2,
           .omits = {no_quadratic}},
          {.name = "q2",
           .element = Element::q2,
           .description = "triquadratic (27 nodes), 3x3x3 points; hexahedra only",
           .order = 3,
           .divisions = 2,
           .multigrid_bytes = 33e3,
           .entries_per_node = of_q2}};
}

std::vector<Method> finite_element_methods() {
  const std::vector<Model> of_all_elements{
      {.element = "q1"},
      {.element = "q1-sri"},
      {.element = "q2"},
      {.element = "q1-nodal", .cells = CellType::tetrahedron}};
  std::vector<Model> of_all_elements_and_solvers = of_all_elements;
  for (const char* linear_solver : {"direct", "multigrid"})
    of_all_elements_and_solvers.push_back(
        {.element = "q1-sri", .linear_solver = linear_solver});
  of_all_elements_and_solvers.push_back(
      {.element = "q1", .cells = CellType::tetrahedron});
  return {
      of_elements(Law::hooke, {.name = "fem-hooke",
                               .source = "linear elasticity",
                               .law = "small-strain Hooke",
                               .look = {"#7F7F7F", "X"},
                               .volume_lost_near_half = 0.032,
                               .foremost = 3,
                               .seconds = of_linear,
                               .charted = of_all_elements,
                               .omits = {{"Hooke's law does here, beside it St-Venant's",
                                          "fem-stvk"}}}),
      of_elements(Law::st_venant_kirchhoff,
                  {.name = "fem-stvk",
                   .source = "Hooke's law between Green's strain and the second "
                             "Piola-Kirchhoff stress",
                   .law = "St-Venant-Kirchhoff",
                   .look = {"#D55E00", "P"},
                   .volume_lost_near_half = 0.064,
                   .foremost = 2,
                   .bar_limit = {1 - std::numbers::inv_sqrt3,  // where d/dl (l^3 - l) = 0
                                 "the stretch 1/√3 at which a bar of St-Venant and "
                                 "Kirchhoff's law bears its largest force"},
                   .seconds = of_others,
                   .charted = of_all_elements_and_solvers,
                   .omits = {no_small_strain, {"No logarithmic strain", "fem-hencky"}}}),
      of_elements(Law::hencky, {.name = "fem-hencky",
                                .source = "Hencky 1928",
                                .law = "Hencky, logarithmic strain",
                                .look = {"#000000", "s"},
                                .volume_lost_near_half = 0.0008,
                                .foremost = 1,
                                .of_thesis = true,
                                .seconds = of_others,
                                .charted = of_all_elements,
                                .omits = {no_small_strain}}),
      of_elements(Law::cauchy_born,
                  {.name = "fem-cauchy-born",
                   .description = "finite elements, the continuum of a spring "
                                  "lattice (option --lattice)",
                   .source = "the lattice's energy under the Cauchy-Born rule",
                   .law = "continuum of a spring lattice",
                   .look = {"#8C6BB1", "h"},
                   .reads = {"lattice", "lattice-direction"},
                   .covers = "; Poisson's ratios above -1/4 of the lattice of mss-baudet",
                   .seconds = of_others,
                   .charted = {{.element = "q1-sri"}}})};
}

fem_reference::Settings elements_of(const CaseSettings& settings, Law law) {
  return {.law = law,
          .element = settings.elements.element.element,
          .lattice = lattice_of(settings)};
}

fem_reference::Lattice lattice_of(const CaseSettings& settings) {
  using fem_reference::SpringConstants;
  const bool from_shear_modulus =
      !reads(settings, "stiffness-form") ||
      settings.springs.stiffness_form == mss::StiffnessForm::shear_modulus;
  const LatticeName& lattice = settings.elements.lattice;
  const mss::NetworkSettings springs = springs_of(settings, lattice.fixed);
  return {.springs = lattice.springs,
          .diagonal_ratio = springs.diagonal_ratio,
          .constants = from_shear_modulus ? SpringConstants::from_shear_modulus
                                          : SpringConstants::from_young_modulus,
          .direction = settings.elements.lattice_direction,
          .strain = strain_of(springs.strain_measure),
          .axes = static_cast<int>(mss::all_of(springs.axes).size())};
}

}  // namespace springcheck
