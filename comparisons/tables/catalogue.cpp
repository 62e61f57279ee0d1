#include "comparisons/tables/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

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
#include "comparisons/tables/thesis/tables.hpp"
#include "comparisons/tables/tissue/oscillation_table.hpp"
#include "comparisons/tables/tissue/relaxation_table.hpp"
#include "comparisons/tables/tissue/tissue_table.hpp"
#include "comparisons/tables/tissue/torsion_table.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {

const std::vector<std::string>& sheet_names() {
  static const std::vector<std::string> names{"5.5",
                                              "split",
                                              "elements",
                                              "convergence",
                                              "subdivision",
                                              "locking",
                                              "orientation",
                                              "modes",
                                              "performance",
                                              "dynamics",
                                              "lattice-stability",
                                              "regions",
                                              "four-springs",
                                              "growth",
                                              "tissue",
                                              "tissue-relaxation",
                                              "tissue-oscillation",
                                              "tissue-torsion"};
  return names;
}

const std::vector<std::string>& caseless_sheet_names() {
  static const std::vector<std::string> names{
      "modes", "performance", "lattice-stability", "regions", "four-springs", "growth"};
  return names;
}

const std::vector<std::string>& long_sheet_names() {
  static const std::vector<std::string> names{"split", "growth"};
  return names;
}

SheetPlan plan_sheet(const std::string& name) {
  if (name == "5.5") return plan_meshes_table();
  if (name == "split") return plan_split_table();
  if (name == "elements") return plan_elements_table();
  if (name == "convergence") return plan_convergence_table();
  if (name == "subdivision") return plan_subdivision_table();
  if (name == "locking") return plan_locking_table();
  if (name == "orientation") return plan_orientation_table();
  if (name == "modes") return plan_modes_table();
  if (name == "dynamics") return plan_dynamics_table();
  if (name == "performance") return plan_performance_table();
  if (name == "growth") return plan_growth_table();
  if (name == "tissue") return plan_tissue_table();
  if (name == "tissue-relaxation") return plan_tissue_relaxation_table();
  if (name == "tissue-oscillation") return plan_tissue_oscillation_table();
  if (name == "tissue-torsion") return plan_tissue_torsion_table();
  if (name == "lattice-stability") return plan_lattice_stability_table();
  if (name == "regions") return plan_regions_table();
  if (name == "four-springs") return plan_four_springs_table();
  throw std::logic_error("no sheet '" + name + "'");
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
