#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparisons/cases/grids.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/case_json.hpp"
#include "comparisons/settings/run_settings.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

/// The grid of hexahedra that a reference runs on beside a case.
Body grid_beside(const ReferenceMethod& reference, const Body& body) {
  if (body.shape != BodyShape::block)
    throw InputError(reference.place, "grid of the reference",
                     fmt::format("a block, which regular grids can cut; the mesh of a {} "
                                 "is its reference's too",
                                 name_of(body.shape)),
                     "'" + reference.text + "'");
  check_not_cut(body,
                fmt::format("the reference '{}', on cells of its own", reference.text));
  const Cells& cells = body.block.cells;
  if (reference.cells.empty()) return on_hexahedra(body, cells);
  const auto refuse = [&](const std::string& expected) {
    throw InputError(reference.place, "cells of the reference",
                     fmt::format("{} the case's {}", expected, fmt::join(cells, ",")),
                     fmt::format("{}", fmt::join(reference.cells, ",")));
  };
  if (reference.cells.size() == 1) {
    const int along_x = reference.cells.front();
    if (along_x % cells[0] != 0) refuse("a whole multiple of the first of");
    return on_hexahedra(body, refined(cells, along_x / cells[0]));
  }
  const Cells finer{reference.cells[0], reference.cells[1], reference.cells[2]};
  if (!is_refinement(finer, cells)) refuse("whole multiples of");
  return on_hexahedra(body, finer);
}

}  // namespace

bool deforms_little(const RunSettings& run) {
  const std::optional<double>& deformation = run.common.deformation;
  const double last = last_load(run.common.dynamics);
  return deformation && std::abs(last * *deformation) <= small_deformation;
}

ReferenceMethod usual_reference(Deformations deformations) {
  return {usual_law(deformations == Deformations::small), *find_element("q1-sri")};
}

std::vector<Request> requests(const RunSettings& run) {
  return requests(run, usual_reference(deforms_little(run) ? Deformations::small
                                                           : Deformations::any));
}

std::vector<Request> requests(const RunSettings& run, const ReferenceMethod& usual) {
  const double last = last_load(run.common.dynamics);
  const ReferenceMethod reference = run.reference.value_or(usual);
  std::vector<Request> all;
  for (const MethodChoice& choice : run.methods) {
    const Method& method = choice.method;
    Request request{.settings = with_method(run.common, choice),
                    .reference = with_reference_method(run.common, reference)};

    if (reference.grid == ReferenceGrid::converged || !reference.cells.empty())
      request.reference->body = grid_beside(reference, run.common.body);
    request.reference_grid = reference.grid;
    const bool is_limit = solver_of(request.settings) == Solver::path_limit ||
                          solver_of(*request.reference) == Solver::path_limit;
    const bool has_no_load = !has_history(*request.reference) && last == 0;
    request.settings = at_last_load(request.settings);
    request.reference = at_last_load(*request.reference);
    if (is_limit || has_no_load || (!method.is_elastic && !run.reference)) {
      // A limit is no state at the load, nor is a body at rest without one, and the usual
      // reference is elastic.
      if (has_no_load && (method.is_elastic || run.reference))
        request.no_reference = "the load ends at 0: no deviation from bodies at rest";
      request.reference.reset();
      request.reference_grid = ReferenceGrid::one;
      all.push_back(request);
      continue;
    }
    if (reference.grid == ReferenceGrid::one &&
        settings_json(request.settings) == settings_json(*request.reference))
      request.reference.reset();
    all.push_back(request);
  }
  return all;
}

}  // namespace springcheck
