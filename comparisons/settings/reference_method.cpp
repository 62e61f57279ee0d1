#include "comparisons/settings/reference_method.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "comparisons/methods/methods.hpp"
#include "comparisons/names/suggestion.hpp"
#include "comparisons/settings/setting_values.hpp"

namespace springcheck {
namespace {

/// The counts in "N" or "NX,NY,NZ" behind a reference's '@'.
std::vector<int> reference_cells_of(const Given& given, const std::string& text) {
  const std::string expected =
      "a method, or METHOD:ELEMENT, METHOD:SOLVER or METHOD:ELEMENT:SOLVER, and behind "
      "it @NX,NY,NZ, @N or "
      "@converged, counts of at least 1";
  std::vector<int> cells;
  std::istringstream counts(text);
  for (std::string count; std::getline(counts, count, ',');) {
    int value = 0;
    const auto [end, error] =
        std::from_chars(count.data(), count.data() + count.size(), value);
    if (error != std::errc{} || end != count.data() + count.size() || value < 1)
      given.refuse(expected);
    cells.push_back(value);
  }
  if ((cells.size() != 1 && cells.size() != 3) || text.back() == ',')
    given.refuse(expected);
  return cells;
}

/// The solver of that name by which the method reaches the load.
Solver reference_solver_of(const Given& given, const Method& method,
                           const std::string& name) {
  std::vector<std::string_view> names;
  for (const Solver solver : method.solvers)
    if (solver != Solver::path_limit) names.push_back(name_of(solver));
  if (!method.follows_solver || names.size() < 2)
    given.refuse(method.name + " without a solver: as a reference it has one");
  if (std::ranges::count(names, name) == 0) given.refuse_name(name, names);
  return value_named<Solver>(given, name);
}

}  // namespace

CaseSettings with_reference_method(CaseSettings settings,
                                   const ReferenceMethod& reference) {
  settings.method = reference.method;
  settings.elements.element = reference.element;
  if (reference.solver) settings.solver = reference.solver;
  if (reference.method.follows_solver) return settings;
  // The reference is a body at rest under the load, whatever the case is.
  settings.solver.reset();
  return without_noise(settings);
}

ReferenceMethod reference_named(const Given& given) {
  const std::string text = given.joined();
  const std::size_t at = text.find('@');
  const std::string what = text.substr(0, at);
  const std::size_t colon = what.find(':');
  ReferenceMethod reference{.method = value_named<Method>(given, what.substr(0, colon)),
                            .element = *find_element("q1-sri"),
                            .place = given.place(),
                            .text = text};
  if (colon != std::string::npos) {
    std::string by = what.substr(colon + 1);
    bool has_solver = true;
    if (reads(reference.method, "element")) {
      const std::size_t end = std::min(by.find(':'), by.size());
      reference.element = value_named<ElementName>(given, by.substr(0, end));
      has_solver = end < by.size();
      by.erase(0, end + 1);
    }
    if (has_solver) reference.solver = reference_solver_of(given, reference.method, by);
  }
  if (at == std::string::npos) return reference;
  if (reference.method.belongs_to_cells)
    given.refuse(reference.method.name +
                 " on the case's own mesh: its constants belong to those cells");
  const std::string grid = text.substr(at + 1);
  if (grid == "converged")
    reference.grid = ReferenceGrid::converged;
  else if (!nearest(grid, {"converged"}).empty())
    given.refuse_name(grid, {"converged"});
  else
    reference.cells = reference_cells_of(given, grid);
  return reference;
}

}  // namespace springcheck
