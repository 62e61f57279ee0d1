#include "comparisons/cases/request.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "comparisons/cases/convergence_grids.hpp"

namespace springcheck {

std::vector<CaseSettings> reference_cases(const Request& request) {
  if (!request.reference) return {};
  if (request.reference_grid == ReferenceGrid::one) return {*request.reference};
  const ThreeCases grids = convergence_grids(*request.reference);
  return {grids.begin(), grids.end()};
}

std::string reference_label(const Request& request) {
  if (!request.reference) return {};
  std::string name = label(*request.reference);
  const Method& method = request.reference->method;
  const Solver solver = solver_of(*request.reference);
  if (method.follows_solver && method.solvers.size() > 1 &&
      (solver != method.solvers.front() || solver != solver_of(request.settings)))
    name += fmt::format(":{}", name_of(solver));
  if (request.reference_grid == ReferenceGrid::converged) return name + "@converged";
  const Body& body = request.reference->body;
  if (body == request.settings.body) return name;
  return fmt::format("{}@{}", name, fmt::join(body.block.cells, ","));
}

}  // namespace springcheck
