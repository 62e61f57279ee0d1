#include "comparisons/tables/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/names/suggestion.hpp"
#include "comparisons/tables/studies/convergence_table.hpp"
#include "comparisons/tables/studies/dynamics_table.hpp"
#include "comparisons/tables/studies/elements_table.hpp"
#include "comparisons/tables/studies/growth_table.hpp"
#include "comparisons/tables/studies/locking_table.hpp"
#include "comparisons/tables/studies/performance_table.hpp"
#include "comparisons/tables/studies/split_table.hpp"
#include "comparisons/tables/studies/subdivision_table.hpp"
#include "comparisons/tables/theory/four_springs_table.hpp"
#include "comparisons/tables/theory/lattice_stability_table.hpp"
#include "comparisons/tables/theory/modes_table.hpp"
#include "comparisons/tables/theory/orientation_table.hpp"
#include "comparisons/tables/theory/regions_table.hpp"
#include "comparisons/tables/thesis/meshes_table.hpp"
#include "comparisons/tables/thesis/thesis_tables.hpp"
#include "comparisons/tables/tissue/oscillation_table.hpp"
#include "comparisons/tables/tissue/rates_table.hpp"
#include "comparisons/tables/tissue/relaxation_table.hpp"
#include "comparisons/tables/tissue/tissue_table.hpp"
#include "comparisons/tables/tissue/torsion_table.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

// clang-format off
constexpr CatalogueEntry entries[] = {
    {"5.1", "Volume change in compression (thesis, table 5.1)",
     "volume change in compression, printed in the thesis and ours",
     plan_compression, "thesis-tables", .6},
    {"5.2", "Volume change in tension (thesis, table 5.2)",
     "volume change in tension, printed and ours",
     plan_tension, "thesis-tables", .1},
    {"5.3", "Force on the plate in shearing (thesis, table 5.3)",
     "force on the plate in shearing, printed and ours",
     plan_shearing, "thesis-tables", .06},
    {"5.4", "Torque on the plate in torsion (thesis, table 5.4)",
     "torque on the plate in torsion, printed and ours",
     plan_torsion, "thesis-tables", .09},
    {"deviation", "Distance of springs' points from the reference's, section 5.6.2",
     "deviation from the reference's points, printed and ours",
     plan_deviation, "thesis-tables", .3},
    {"bending", "Beams under gravity, figures 5.15 to 5.19: tip deflection",
     "a beam's tip, printed and ours, beside beam theory",
     plan_bending, "thesis-tables", .6},
    {"5.5", "Meshes of the performance study, printed and counted (thesis, table 5.5)",
     "cells, nodes and springs of the thesis's meshes, printed and counted; needs no "
     "simulation",
     plan_meshes_table, "thesis-tables", .02, Source::counting},
    {"split", "Where mss-cf's error comes from, nu = 0.25: law and discretisation",
     "where mss-cf's error comes from in the five tests: law or discretisation",
     plan_split_table, "error-parts", 18},
    {"laws", "Springs of all laws in large deformation: law and discretisation",
     "the same at 20 % and 45 degrees, nu 0, 0.25 and 0.4: mss-cf beside springs "
     "that follow a law of finite elements",
     plan_laws_table, "error-parts", 21},
    {"elements", "Springs and finite elements on any cells, about 5 across",
     "springs and finite elements on cubes, distorted mixed cells and gmsh's "
     "tetrahedra: forces off Hooke q2 and off converged values, volumes off their "
     "own law",
     plan_elements_table, "elements", 1.5},
    {"convergence", "Convergence in the mesh: shearing at a deformation of 1e-5",
     "errors on 2, 4, 8, 16 cells across by method and type of cells, with fitted "
     "orders: data for a plot",
     plan_convergence_table, "convergence", .5},
    {"subdivision", "Cells against what they can be cut into, nu = 0.25",
     "hexahedra and prisms against the cells they can be cut into, five tests at 5 "
     "and 20 %",
     plan_subdivision_table, "subdivision", .1},
    {"locking", "Locking: plate force in compression by 5 % near nu = 0.5, by element",
     "volumetric locking: plate force near nu = 0.5 with q1, q1-sri, q2",
     plan_locking_table, "locking", .3},
    {"orientation", "Stress against the direction of the load in the springs' frame",
     "stress against the direction of the load, uniaxial and in simple shear: mss-cf "
     "and mss-affine",
     plan_orientation_table, "orientation", .02},
    {"modes", "Lowest natural frequencies of a free cube and of a cantilever",
     "lowest natural frequencies of a free cube and of a cantilever: springs against "
     "finite elements, beam theory and Rayleigh-Ritz; needs no simulation",
     plan_modes_table, "modes", .3, Source::when_printed},
    {"performance",
     "Time of explicit steps, figures 5.20 to 5.25 and the two printed times",
     "time of explicit steps on this machine by method, precision, cells and "
     "threads, beside the thesis's two printed times; measured as it is printed",
     plan_performance_table, "speed", .8, Source::when_printed},
    {"dynamics", "Statics and dynamics: mss-cf's figures of tables 5.1 to 5.4",
     "mss-cf's printed figures, static and at the end of 10 s of dynamics, in SI and "
     "in the thesis's own units: what the protocol alone changes",
     plan_dynamics_table, "through-time", .5},
    {"lattice-stability",
     "First loss of stability of the infinite lattice under uniaxial stress",
     "theory of failure: the strain at which the infinite lattice loses its first "
     "plane wave, or its free sides, against A and nu, and which wave; needs no "
     "simulation",
     plan_lattice_stability_table, "stability-theory", .3, Source::when_printed},
    {"regions", "Stability regions of the integrators, figures 2.2 and 2.3",
     "stability regions of the integrators, figures 2.2 and 2.3, found by stepping, "
     "beside those on paper; needs no simulation",
     plan_regions_table, "stability-theory", .01, Source::when_printed},
    {"four-springs", "The four springs that buckle, figure 3.2",
     "the buckling and the loop of figure 3.2; needs no simulation",
     plan_four_springs_table, "stability-theory", .01, Source::when_printed},
    {"growth", "How time and memory grow with the cells",
     "time and memory of explicit steps, direct and iterative static solutions from "
     "10^3 to 10^6 cells, with fitted exponents; leaves out sizes that need more "
     "memory than is left or a quarter of an hour; measured as it is printed",
     plan_growth_table, "speed", 12, Source::when_printed},
    {"tissue", "Bi-power tissue in simple shear at constant rate",
     "liver, kidney and spleen in shear at the thesis's three rates: the bi-power "
     "law of chapter 4, the Maxwell branches fitted to it, mss-tissue, and the "
     "thesis's spring force (Eq. 4.4) as printed and repaired",
     plan_tissue_table, "tissue", .1},
    {"tissue-rates", "Bi-power tissue in simple shear, by rate",
     "stress in shear against its rate, .001 to 50 1/s, in the range of the fit and "
     "beyond: law, branches, mss-tissue",
     plan_tissue_rates_table, "tissue", .2},
    {"tissue-relaxation", "Bi-power tissue sheared to 100 %, then held or unloaded",
     "the same sheared to 100 %, then held for .1 to 100 s or unloaded: law and "
     "mss-tissue",
     plan_tissue_relaxation_table, "tissue", .05},
    {"tissue-oscillation", "Storage and loss modulus of bi-power tissue",
     "G' and G'' from .1 to 100 rad/s: law, branches, mss-tissue",
     plan_tissue_oscillation_table, "tissue", .3},
    {"tissue-torsion", "Torque on a disc of bi-power tissue between a rheometer's plates",
     "torque on a disc of 15 mm between a rheometer's plates: law, and mss-tissue on "
     "three meshes",
     plan_tissue_torsion_table, "tissue", .9}};
// clang-format on

/// Minutes from which on a table is long.
constexpr double long_from = 10;

/// The plan, whose table gets the name and title of the entry.
TablePlan named(TablePlan plan, const CatalogueEntry& entry) {
  plan.make = [&entry, make = std::move(plan.make)](std::span<const CaseResult> results,
                                                    MeshStore& meshes) {
    Table table = make(results, meshes);
    table.name = entry.name;
    table.title = entry.title;
    return table;
  };
  if (plan.of_rows)
    plan.of_rows = [&entry, of_rows = std::move(plan.of_rows)](
                       const std::vector<std::size_t>& rows) {
      return named(of_rows(rows), entry);
    };
  return plan;
}

}  // namespace

std::span<const CatalogueEntry> catalogue() {
  return entries;
}

const CatalogueEntry& table_named(std::string_view name) {
  const auto* found = std::ranges::find(entries, name, &CatalogueEntry::name);
  if (found != std::end(entries)) return *found;
  std::vector<std::string_view> names;
  for (const CatalogueEntry& entry : entries) names.push_back(entry.name);
  refuse_name("springcheck table", "table", name, names);
}

bool is_of_printed_figures(const CatalogueEntry& entry) {
  return std::holds_alternative<CatalogueEntry::OfPrintedFigures>(entry.plan);
}

bool takes_long(const CatalogueEntry& entry) {
  return entry.minutes >= long_from;
}

TablePlan plan_of(const CatalogueEntry& entry,
                  const std::optional<ReferenceMethod>& reference) {
  if (const auto* of_ours = std::get_if<CatalogueEntry::OfOurs>(&entry.plan)) {
    if (reference)
      throw InputError(reference->place, "",
                       fmt::format("no reference: table {} has its", entry.name), "one");
    return named((*of_ours)(), entry);
  }
  const auto of_printed = std::get<CatalogueEntry::OfPrintedFigures>(entry.plan);
  return named(table_plan(of_printed(reference)), entry);
}

Table table_of_tables() {
  Table table{.name = "tables",
              .title = "What springcheck table prints",
              .columns = {{"table", "table"},
                          {"minutes", "minutes", "{:g}"},
                          {"source", "source"},
                          {"title", "title"},
                          {"section", "section of the page"}},
              .notes = {"Minutes: about, on two cores, where no result file has any of "
                        "its cases."}};
  for (const CatalogueEntry& entry : entries)
    table.rows.push_back({.cells = {entry.name, entry.minutes, name_of(entry.source),
                                    entry.title, entry.section}});
  return table;
}

}  // namespace springcheck
