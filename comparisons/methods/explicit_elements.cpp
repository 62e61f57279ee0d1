#include "comparisons/methods/families.hpp"

#include "comparisons/cases/case.hpp"
#include "comparisons/methods/protocol.hpp"
#include "fem_reference/explicit/explicit_dynamics.hpp"

namespace springcheck {
namespace {

using fem_reference::ExplicitElement;

fem_reference::ExplicitSettings explicit_settings(const CaseSettings& settings,
                                                  ExplicitElement element, int threads) {
  return {.element = element,
          .protocol = protocol_of(settings),
          .damping_ratio = settings.dynamics.damping_ratio,
          .precision = settings.dynamics.precision,
          .threads = threads};
}

Method that_step(ExplicitElement element, Method own) {
  own.family = Family::finite_elements;
  own.reads = {"damping", "precision"};
  own.cells = {CellType::hexahedron};
  own.solvers = {Solver::semi_implicit_euler, Solver::explicit_euler, Solver::verlet};
  own.solve = [element](const CaseSettings& settings, const Mesh& mesh,
                        const Scene& scene, int threads,
                        const dynamics::Observers& observers) {
    if (!goes_through_time(settings))
      return refused("fem-explicit steps explicitly; fem-stvk has the static solver");
    return fem_reference::run_dynamics(
        mesh, scene, explicit_settings(settings, element, threads), observers);
  };
  own.stepping = [element](const CaseSettings& settings, const Mesh& mesh,
                           const Scene& scene) -> MakeMotion {
    return [&mesh, &scene, element, settings](const SteppingOptions& options) {
      return fem_reference::motion_of(
          mesh, scene, explicit_settings(settings, element, options.threads),
          options.instruction_set);
    };
  };
  own.covers = "hexahedra of any shape; motions alone, by explicit steps";
  own.charted = {{.precision = dynamics::Precision::double_precision},
                 {.precision = dynamics::Precision::single_precision}};
  own.seconds = {.in_motion = 0.03, .in_motion_off_grids = 0.03};
  own.linear_systems = [](const CaseSettings&) { return LinearSystems{}; };
  return own;
}

}  // namespace

std::vector<Method> explicit_element_methods() {
  return {
      that_step(ExplicitElement::one_point,
                {.name = "fem-explicit-1p",
                 .description = "finite elements stepped explicitly, "
                                "St-Venant-Kirchhoff at one point with hourglass "
                                "control; hexahedra only",
                 .source = "Flanagan and Belytschko 1981, with a stiffness of our own",
                 .look = {"#1B7F8C", "8"},
                 .foremost = 5,
                 .omits = {{"No further points of integration", "fem-explicit-8p"}}}),
      that_step(ExplicitElement::eight_points,
                {.name = "fem-explicit-8p",
                 .description = "the same at 2x2x2 points: locks near nu = 0.5",
                 .source = "St-Venant-Kirchhoff on trilinear hexahedra",
                 .look = {"#A50F5A", "H"},
                 .locks = true,
                 .foremost = 4,
                 .at_rest = "fem-stvk:q1"})};
}

}  // namespace springcheck
