#include "comparisons/stability/atlas_cases.hpp"

#include <fmt/format.h>

#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

/// The control of a case: the same body by elements that do not lock, where there are any
/// of the same law.
std::optional<CaseSettings> control_of(const CaseSettings& settings) {
  CaseSettings control = without_noise(settings);
  control.elements.element = *find_element("q1-sri");
  if (reads(settings.method, "element"))
    return label(control) == label(settings) ? std::nullopt : std::optional(control);
  if (!settings.method.lattice || goes_through_time(settings) ||
      !is_grid_of_hexahedra(settings.body) ||
      (settings.method.lattice->of_cubes && !is_grid_of_cubes(settings.body)))
    return std::nullopt;
  control.method = continuum_of_lattices();
  control.elements.lattice = *settings.method.lattice;
  return control;
}

}  // namespace

std::vector<CaseSettings> cases_at(const AtlasPlan& plan,
                                   const std::vector<std::string>& values) {
  GivenSettings options = plan.options;
  for (std::size_t i = 0; i < plan.axes.size(); ++i) {
    options.push_back(setting(plan.axes[i], values[i]));
    if (plan.axes[i].key ==
        "dt")  // what becomes of steps above the limit is the question
      options.push_back({"force-dt", Given("--over dt", true)});
  }
  const RunSettings run = read_run(plan.scene, options);
  std::vector<CaseSettings> cases;
  for (const MethodChoice& choice : run.methods) {
    cases.push_back(with_method(run.common, choice));
    if (last_load(run.common.dynamics) != 1 && !has_history(cases.back()))
      throw InputError(
          "stability", "load-fractions",
          "a path that ends with the whole load, at which " + choice.method.name +
              " is at rest",
          fmt::format("one that ends at {:g} of it", last_load(run.common.dynamics)));
  }
  return cases;
}

std::vector<Failure> failures_of(const AtlasPlan& plan, CaseRunner& runner,
                                 const std::vector<CaseResult>& results,
                                 std::map<std::size_t, std::string>* controls) {
  std::vector<Failure> failures;
  std::vector<std::size_t> places;
  std::vector<CaseSettings> cases;
  for (const CaseResult& result : results) {
    failures.push_back(failure_of(result));
    if (!plan.judges_locking || fails(failures.back())) continue;
    if (const auto control = control_of(result.request.settings)) {
      places.push_back(failures.size() - 1);
      cases.push_back(*control);
    }
  }
  const std::vector<CaseResult> found = runner.run(cases);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (locks(results[places[i]], found[i])) failures[places[i]] = Failure::locking;
    if (controls != nullptr) controls->emplace(places[i], found[i].key);
  }
  return failures;
}

}  // namespace springcheck
