#include "comparisons/tables/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>
#include <string_view>

#include "comparisons/tables/studies/study_tables.hpp"
#include "comparisons/tables/theory/theory_tables.hpp"
#include "comparisons/tables/thesis/meshes_table.hpp"
#include "comparisons/tables/thesis/tables.hpp"
#include "comparisons/tables/tissue/tissue_tables.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {

namespace {

enum class Takes { a_while, many_minutes };
enum class Cases { stored, none };

struct Entry {
  std::string_view name, description;
  SheetPlan (*plan)();
  Takes takes = Takes::a_while;
  Cases cases = Cases::stored;
};

constexpr std::array entries{
    Entry{
        "5.5",
        "cells, nodes and springs of the thesis's meshes, printed and counted; needs no "
        "simulation",
        plan_meshes_table},
    Entry{"split",
          "where mss-cf's error comes from in the five tests: law or discretisation",
          plan_split_table, Takes::many_minutes},
    Entry{
        "laws",
        "the same at 20 % and 45 degrees, nu 0, 0.25 and 0.4: mss-cf beside springs that "
        "follow a law of finite elements",
        plan_laws_table, Takes::many_minutes},
    Entry{"elements",
          "springs and finite elements on cubes, distorted mixed cells and gmsh's "
          "tetrahedra: forces off Hooke q2 and off converged values, volumes off their "
          "own law",
          plan_elements_table},
    Entry{"convergence",
          "errors on 2, 4, 8, 16 cells across by method and type of cells, with fitted "
          "orders: data for a plot",
          plan_convergence_table},
    Entry{"subdivision",
          "hexahedra and prisms against the cells they can be cut into, five tests at 5 "
          "and 20 %",
          plan_subdivision_table},
    Entry{"locking", "volumetric locking: plate force near nu = 0.5 with q1, q1-sri, q2",
          plan_locking_table},
    Entry{
        "orientation",
        "stress against the direction of the load, uniaxial and in simple shear: mss-cf "
        "and mss-affine",
        plan_orientation_table},
    Entry{
        "modes",
        "lowest natural frequencies of a free cube and of a cantilever: springs against "
        "finite elements, beam theory and Rayleigh-Ritz; needs no simulation",
        plan_modes_table, Takes::a_while, Cases::none},
    Entry{
        "performance",
        "time of explicit steps on this machine by method, precision, cells and threads, "
        "beside the thesis's two printed times; measured as it is printed",
        plan_performance_table, Takes::a_while, Cases::none},
    Entry{
        "dynamics",
        "mss-cf's printed figures, static and at the end of 10 s of dynamics, in SI and "
        "in the thesis's own units: what the protocol alone changes",
        plan_dynamics_table},
    Entry{"lattice-stability",
          "theory of failure: the strain at which the infinite lattice loses its first "
          "plane wave, or its free sides, against A and nu, and which wave; needs no "
          "simulation",
          plan_lattice_stability_table, Takes::a_while, Cases::none},
    Entry{"regions",
          "stability regions of the integrators, figures 2.2 and 2.3, found by stepping, "
          "beside those on paper; needs no simulation",
          plan_regions_table, Takes::a_while, Cases::none},
    Entry{"four-springs", "the buckling and the loop of figure 3.2; needs no simulation",
          plan_four_springs_table, Takes::a_while, Cases::none},
    Entry{"growth",
          "time and memory of explicit steps, direct and iterative static solutions from "
          "10^3 to 10^6 cells, with fitted exponents; leaves out sizes that need more "
          "memory than is left or a quarter of an hour; measured as it is printed",
          plan_growth_table, Takes::many_minutes, Cases::none},
    Entry{
        "tissue",
        "liver, kidney and spleen in shear at the thesis's three rates: the bi-power law "
        "of chapter 4, the Maxwell branches fitted to it, mss-tissue, and the thesis's "
        "spring force (Eq. 4.4) as printed and repaired",
        plan_tissue_table},
    Entry{"tissue-rates",
          "stress in shear against its rate, .001 to 50 1/s, in the range of the fit and "
          "beyond: law, branches, mss-tissue",
          plan_tissue_rates_table},
    Entry{"tissue-relaxation",
          "the same sheared to 100 %, then held for .1 to 100 s or unloaded: law and "
          "mss-tissue",
          plan_tissue_relaxation_table},
    Entry{"tissue-oscillation",
          "G' and G'' from .1 to 100 rad/s: law, branches, mss-tissue",
          plan_tissue_oscillation_table},
    Entry{
        "tissue-torsion",
        "torque on a disc of 15 mm between a rheometer's plates: law, and mss-tissue on "
        "three meshes",
        plan_tissue_torsion_table}};

std::vector<std::string> names_where(const std::function<bool(const Entry&)>& wanted) {
  std::vector<std::string> names;
  for (const Entry& entry : entries)
    if (wanted(entry)) names.emplace_back(entry.name);
  return names;
}

}  // namespace

const std::vector<std::string>& sheet_names() {
  static const auto names = names_where([](const Entry&) { return true; });
  return names;
}

const std::vector<std::string>& caseless_sheet_names() {
  static const auto names =
      names_where([](const Entry& entry) { return entry.cases == Cases::none; });
  return names;
}

const std::vector<std::string>& long_sheet_names() {
  static const auto names =
      names_where([](const Entry& entry) { return entry.takes == Takes::many_minutes; });
  return names;
}

std::vector<Described> described_tables() {
  std::vector<Described> all = described_thesis_tables();
  for (const Entry& entry : entries) all.push_back({entry.name, entry.description});
  return all;
}

SheetPlan plan_sheet(const std::string& name) {
  const auto* entry = std::ranges::find(entries, name, &Entry::name);
  if (entry == entries.end()) throw std::logic_error("no sheet '" + name + "'");
  return entry->plan();
}

void check_table_name(const std::string& name) {
  if (std::ranges::count(table_names(), name) + std::ranges::count(sheet_names(), name) >
      0)
    return;
  throw InputError("table", "",
                   fmt::format("one of {}, {}", fmt::join(table_names(), ", "),
                               fmt::join(sheet_names(), ", ")),
                   "'" + name + "'");
}

}  // namespace springcheck
