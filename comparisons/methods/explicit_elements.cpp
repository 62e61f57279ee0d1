#include "comparisons/methods/families.hpp"

#include "comparisons/cases/case.hpp"
#include "comparisons/methods/protocol.hpp"
#include "fem_reference/explicit/explicit_dynamics.hpp"
#include "fem_reference/motion/moving_elements.hpp"

namespace springcheck {
namespace {

using fem_reference::ExplicitElement;
using fem_reference::Law;

fem_reference::ExplicitSettings explicit_settings(const CaseSettings& settings,
                                                  ExplicitElement element, int threads) {
  return {.element = element,
          .protocol = protocol_of(settings),
          .damping_ratio = settings.dynamics.damping_ratio,
          .precision = settings.dynamics.precision,
          .threads = threads};
}

/// A method with what all methods have that step.
Method that_step(Method own) {
  own.family = Family::finite_elements;
  own.reads.insert(own.reads.end(), {"damping", "precision"});
  own.solvers = {Solver::semi_implicit_euler, Solver::explicit_euler, Solver::verlet};
  own.linear_systems = [](const CaseSettings&) { return LinearSystems{}; };
  return own;
}

Method hexahedra_that_step(ExplicitElement element, Method own) {
  own.cells = {CellType::hexahedron};
  own.solve = [element](const CaseSettings& settings, const Mesh& mesh,
                        const Scene& scene, int threads,
                        const dynamics::Observers& observers) {
    if (!goes_through_time(settings))
      return refused("it steps explicitly; fem-stvk has the static solver");
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
  return that_step(std::move(own));
}

fem_reference::MotionSettings motion_settings(const CaseSettings& settings, Law law,
                                              int threads) {
  return {.elements = elements_of(settings, law),
          .protocol = protocol_of(settings),
          .damping_ratio = settings.dynamics.damping_ratio,
          .threads = threads};
}

/// The method that is `own.at_rest` in motion, with its source, its mark and what its law
/// is like.
Method elements_that_step(Law law, Method own) {
  for (const Method& rest : finite_element_methods())
    if (rest.name == own.at_rest) {
      own.source = rest.source;
      own.look.mark = rest.look.mark;
      own.volume_lost_near_half = rest.volume_lost_near_half;
    }
  own.description = "finite elements stepped explicitly, " + own.description;
  own.reads.push_back("element");
  own.refused_elements = {"q2"};
  own.cells = {all_cell_types.begin(), all_cell_types.end()};
  own.covers =
      "cells of any shape, q1, q1-sri and q1-nodal; motions alone, by explicit "
      "steps in double precision" +
      own.covers;
  own.solve = [law](const CaseSettings& settings, const Mesh& mesh, const Scene& scene,
                    int threads, const dynamics::Observers& observers) {
    if (!goes_through_time(settings))
      return refused("it steps explicitly; " + std::string(settings.method.at_rest) +
                     " has the static solver");
    if (settings.dynamics.precision == dynamics::Precision::single_precision)
      return refused("single precision is for fem-explicit-1p and fem-explicit-8p");
    return fem_reference::run_dynamics(
        mesh, scene, motion_settings(settings, law, threads), observers);
  };
  own.stepping = [law](const CaseSettings& settings, const Mesh& mesh,
                       const Scene& scene) -> MakeMotion {
    return [&mesh, &scene, law, settings](const SteppingOptions& options) {
      return fem_reference::motion_of(mesh, scene,
                                      motion_settings(settings, law, options.threads),
                                      options.instruction_set);
    };
  };
  return that_step(std::move(own));
}

constexpr Omission no_moving_hooke{"Not Hooke's law", "fem-explicit-hooke"};

/// Times by plain loops: those of q1, q1-sri and q1-nodal on hexahedra and tetrahedra are
/// within 20 %.
constexpr Seconds by_loops_in(double seconds) {
  return {.in_motion = seconds, .in_motion_off_grids = seconds};
}

}  // namespace

std::vector<Method> explicit_element_methods() {
  constexpr auto in_double = dynamics::Precision::double_precision;
  const std::vector<Model> on_tetrahedra{
      {.element = "q1-nodal", .cells = CellType::tetrahedron, .precision = in_double}};
  // On hexahedra the elements of St-Venant's law have their kernels.
  const std::vector<Model> on_both{on_tetrahedra.front(),
                                   {.element = "q1-sri", .precision = in_double}};
  return {
      hexahedra_that_step(
          ExplicitElement::one_point,
          {.name = "fem-explicit-1p",
           .description = "finite elements stepped explicitly, "
                          "St-Venant-Kirchhoff at one point with hourglass "
                          "control; hexahedra only",
           .source = "Flanagan and Belytschko 1981, with a stiffness of our own",
           .look = {"#1B7F8C", "8"},
           .foremost = 5,
           .omits = {{"No further points of integration", "fem-explicit-8p"}}}),
      hexahedra_that_step(ExplicitElement::eight_points,
                          {.name = "fem-explicit-8p",
                           .description = "the same at 2x2x2 points: locks near nu = 0.5",
                           .source = "St-Venant-Kirchhoff on trilinear hexahedra",
                           .look = {"#A50F5A", "H"},
                           .locks = true,
                           .foremost = 4,
                           .at_rest = "fem-stvk:q1"}),
      elements_that_step(Law::hooke,
                         {.name = "fem-explicit-hooke",
                          .description = "small-strain Hooke; any cells",
                          .look = {"#3B3B58", {}},
                          .at_rest = "fem-hooke",
                          .seconds = by_loops_in(2),
                          .charted = on_tetrahedra,
                          .omits = {{"Hooke's law does here, beside it St-Venant's",
                                     "fem-explicit-stvk"}}}),
      elements_that_step(
          Law::st_venant_kirchhoff,
          {.name = "fem-explicit-stvk",
           .description = "St-Venant-Kirchhoff; any cells",
           .look = {"#5C3D00", {}},
           .at_rest = "fem-stvk",
           .seconds = by_loops_in(2.6),
           .charted = on_tetrahedra,
           .omits = {no_moving_hooke, {"No logarithmic strain", "fem-explicit-hencky"}}}),
      elements_that_step(Law::hencky,
                         {.name = "fem-explicit-hencky",
                          .description = "Hencky, logarithmic strain; any cells",
                          .look = {"#2F4F4F", {}},
                          .at_rest = "fem-hencky",
                          .seconds = by_loops_in(7),
                          .charted = on_both,
                          .omits = {no_moving_hooke}}),
      elements_that_step(
          Law::cauchy_born,
          {.name = "fem-explicit-cauchy-born",
           .description = "the continuum of a spring lattice (option --lattice); any "
                          "cells",
           .look = {"#B39DDB", {}},
           .reads = {"lattice", "lattice-direction"},
           .covers = "; Poisson's ratios above -1/4 of the lattice of mss-baudet",
           .at_rest = "fem-cauchy-born",
           .seconds = by_loops_in(6)})};
}

}  // namespace springcheck
