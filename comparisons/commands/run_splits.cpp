#include "comparisons/commands/run_splits.hpp"

#include <algorithm>

#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

std::vector<Method> methods_of(const RunSettings& run) {
  std::vector<Method> all;
  for (const MethodChoice& choice : run.methods) all.push_back(choice.method);
  return all;
}

}  // namespace

std::vector<std::optional<SplitPlan>> split_plans(const RunSettings& run,
                                                  const std::vector<Request>& requests) {
  const auto has_continuum = [](const Method& method) {
    return method.lattice.has_value();
  };
  const std::vector<Method> asked = methods_of(run);
  if (std::ranges::none_of(asked, has_continuum))
    throw InputError("--split", "method",
                     "at least one of springs whose continuum fem-cauchy-born is: " +
                         names_of(lattices()),
                     names_of(asked));
  if (run.reference &&
      (run.reference->grid == ReferenceGrid::converged || !run.reference->cells.empty() ||
       run.reference->element.name != "q1-sri"))
    throw InputError(run.reference->place, "",
                     "a method alone with --split, which has its own elements and grids",
                     "'" + run.reference->text + "'");
  std::vector<std::optional<SplitPlan>> plans;
  for (const Request& request : requests) {
    const bool is_split = has_continuum(request.settings.method);
    const Solver solver = solver_of(request.settings);
    if (is_split && solver != Solver::static_equilibrium)
      throw InputError("--split", "solver",
                       "static: the end of dynamics and a limit have errors of their own",
                       std::string(name_of(solver)));
    const Method& law = run.reference ? run.reference->method
                                      : followed_law(request.settings, thesis_law());
    plans.push_back(is_split ? std::optional(plan_split(request.settings, law))
                             : std::nullopt);
  }
  return plans;
}

}  // namespace springcheck
