#include "comparisons/methods/families.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "comparisons/methods/protocol.hpp"
#include "fem_reference/tissue/solve_tissue.hpp"
#include "meshing/basics/stopwatch.hpp"
#include "meshing/loads/scene.hpp"
#include "mss/tissue/solve_tissue.hpp"
#include "mss/tissue/thesis_springs.hpp"
#include "mss/tissue/tissue_motion.hpp"
#include "tissue/strain_history.hpp"

namespace springcheck {
namespace {

dynamics::LoadPath load_of(const Dynamics& dynamics) {
  return dynamics.load.empty() ? dynamics::ramp(dynamics.duration) : dynamics.load;
}

dynamics::QuasiStaticSettings quasi_static_of(const CaseSettings& settings) {
  return {.load = load_of(settings.dynamics), .steps = settings.tissue.steps};
}

constexpr const char* no_limit = "tissue has no limit: it gives way with time";

bool asks_for_limit(const CaseSettings& settings) {
  return solver_of(settings) == Solver::path_limit;
}

mss::TissueSettings settings_with(const tissue::MaxwellFit& fit,
                                  const CaseSettings& settings) {
  return {.solid = {.shear = fit.model,
                    .bulk_ratio = tissue::bulk_ratio_of(settings.material.poisson_ratio)},
          .quasi_static = quasi_static_of(settings),
          .protocol = goes_through_time(settings) ? std::optional(protocol_of(settings))
                                                  : std::nullopt};
}

tissue::MaxwellFit fit_of(const CaseSettings& settings) {
  return tissue::fit_maxwell_model(settings.tissue.law, {}, settings.tissue.branches);
}

/// The pace of a load on the ways between its turning points.
struct Pace {
  double largest_fraction = 0;
  double slowest = INFINITY, fastest = 0;  // [1/s] of the load fraction, where it changes
  double shortest_way = INFINITY, longest_hold = 0;  // [s]
};

Pace pace_of(const Dynamics& dynamics) {
  Pace pace;
  dynamics::LoadPoint from{.time = 0, .fraction = 0};
  for (const dynamics::LoadPoint& to : dynamics::turning_points(load_of(dynamics))) {
    pace.largest_fraction = std::max(pace.largest_fraction, std::abs(to.fraction));
    const double time = to.time - from.time;
    const double rate = std::abs(to.fraction - from.fraction) / time;
    if (rate > 0) {
      pace.slowest = std::min(pace.slowest, rate);
      pace.fastest = std::max(pace.fastest, rate);
      pace.shortest_way = std::min(pace.shortest_way, time);
    } else {
      pace.longest_hold = std::max(pace.longest_hold, time);
    }
    from = to;
  }
  return pace;
}

/// Says that the fit is far off the law in its own range; empty where it is not.
std::string poor_fit(const tissue::MaxwellFit& fit) {
  constexpr double band = 0.02;  // at constant rate
  if (fit.errors.constant_rate <= band) return {};
  return fmt::format("{} branches are off the law by up to {:.2g} % in the fitted range",
                     fit.model.branches.size(), 100 * fit.errors.constant_rate);
}

/// Times at which a path of load is looked at: parts of each way between its turning
/// points, of many ways the first and the last ones.
std::vector<double> times_looked_at(const dynamics::LoadPath& load) {
  constexpr std::size_t ways_at_an_end = 8, parts = 4;
  const dynamics::LoadPath turns = dynamics::turning_points(load);
  std::vector<double> times;
  for (std::size_t way = 0; way < turns.size(); ++way) {
    if (way >= ways_at_an_end && way + ways_at_an_end < turns.size()) continue;
    const double from = way == 0 ? 0 : turns[way - 1].time;
    for (std::size_t part = 1; part <= parts; ++part)
      times.push_back(std::lerp(from, turns[way].time,
                                static_cast<double>(part) / static_cast<double>(parts)));
  }
  return times;
}

/// Says that the branches are far off the law on the case's path of load, as where it
/// swings; empty where they are not. They are compared in simple shear by the largest
/// strain, over the largest stress.
std::string poor_path(const tissue::MaxwellFit& fit, const CaseSettings& settings,
                      double largest_strain) {
  constexpr double band = 0.1;
  const dynamics::LoadPath load = load_of(settings.dynamics);
  const double largest_fraction = pace_of(settings.dynamics).largest_fraction;
  if (!(largest_strain > 0 && largest_fraction > 0)) return {};
  tissue::StrainHistory history{.times = {0}, .strains = {0}};
  for (const dynamics::LoadPoint& point : load) {
    history.times.push_back(point.time);
    history.strains.push_back(point.fraction * largest_strain / largest_fraction);
  }
  double largest = 0, off = 0;
  for (const double time : times_looked_at(load)) {
    const double stress = tissue::stress(settings.tissue.law, history, time);
    largest = std::max(largest, std::abs(stress));
    off = std::max(off, std::abs(tissue::stress(fit.model, history, time) - stress));
  }
  if (off <= band * largest) return {};
  return fmt::format(
      "on this path of the load the branches are off the law by up to {:.2g} % of its "
      "largest stress",
      100 * off / largest);
}

/// Solves a case by a fit to the law: solve(tissue, setup) is a solver's part.
template <class Solve>
Solution solve_with_memory(const CaseSettings& settings, const Solve& solve) {
  if (asks_for_limit(settings)) return refused(no_limit);
  const Stopwatch setup;
  const tissue::MaxwellFit fit = fit_of(settings);
  Solution solution = solve(settings_with(fit, settings), setup);
  const bool has_end =
      solution.status == SolveStatus::ok || solution.status == SolveStatus::indefinite;
  if (!has_end) return solution;
  solution.extrapolation =
      extrapolation(fit.range, settings.dynamics, solution.largest_shear_strain.value());
  for (const std::string& poor :
       {poor_fit(fit), poor_path(fit, settings, solution.largest_shear_strain.value())})
    add_reason(solution.reason, poor);
  return solution;
}

Solution solve_by_springs(const CaseSettings& settings, const Mesh& mesh,
                          const Scene& scene, int threads,
                          const dynamics::Observers& observers) {
  return solve_with_memory(
      settings, [&](mss::TissueSettings tissue, const Stopwatch& setup) {
        tissue.threads = threads;
        return mss::solve_tissue(mesh, scene, tissue, observers, setup);
      });
}

Solution solve_by_elements(const CaseSettings& settings, const Mesh& mesh,
                           const Scene& scene, int /*threads*/,
                           const dynamics::Observers& observers) {
  return solve_with_memory(
      settings, [&](const mss::TissueSettings& tissue, const Stopwatch& setup) {
        if (tissue.protocol)
          return refused("fem-tissue goes through equilibria; mss-tissue moves");
        return fem_reference::solve_tissue(mesh, scene, tissue.solid, tissue.quasi_static,
                                           observers, setup);
      });
}

/// The limit that was fitted by hand; Table 4.2 has one for the organs of Table 4.1
/// alone.
std::optional<double> limit_fitted_by_hand(const tissue::BipowerLaw& law) {
  for (const tissue::Organ& organ : tissue::organs())
    if (organ.law == law) return tissue::hand_fitted_limit(organ.name);
  return std::nullopt;
}

Solution solve_thesis_springs(tissue::Elongation elongation, const CaseSettings& settings,
                              const Mesh& mesh, const Scene& scene,
                              const dynamics::Observers& observers) {
  if (asks_for_limit(settings)) return refused(no_limit);
  if (goes_through_time(settings))
    return refused("Eq. 4.4's dashpots have no constant: there is no motion of it");
  const tissue::BipowerLaw& law = settings.tissue.law;
  const auto limit = limit_fitted_by_hand(law);
  if (!limit)
    return refused("Golec 2018 fitted limits by hand, to liver, kidney and spleen alone");
  return mss::move_thesis_springs(
      mesh, scene, {.law = law, .strain_limit = *limit, .elongation = elongation},
      quasi_static_of(settings), observers);
}

/// Steps by kernels, whatever is asked for: plain loops are for other cells.
MakeMotion stepping_of_springs(const CaseSettings& settings, const Mesh& mesh,
                               const Scene& scene) {
  const mss::TissueSettings tissue = settings_with(fit_of(settings), settings);
  const auto body = std::make_shared<mss::TissueBody>(
      mss::build_tissue_body(mesh, tissue.solid, scene.material.density));
  return [&mesh, &scene, body, integrator = protocol_of(settings).integrator](
             const SteppingOptions& options) -> std::unique_ptr<dynamics::Motion> {
    return std::make_unique<mss::TissueMotion>(
        mesh, scene, *body,
        mss::TissueMotionSettings{.integrator = integrator, .threads = options.threads},
        options.instruction_set);
  };
}

/// A method with what all methods of tissue have.
Method of_tissue(Method own) {
  own.reads.insert(own.reads.end(), {"organ", "law", "time-steps"});
  own.is_elastic = false;
  own.has_history = true;
  own.seconds.at_rest = 0.5;
  own.linear_systems = [](const CaseSettings& settings) -> LinearSystems {
    if (!needs_tangents(settings)) return {};
    return {.kind = LinearSystems::Kind::cholesky};
  };
  return own;
}

Method of_thesis(tissue::Elongation elongation, Method own) {
  own.family = Family::springs;
  own.source = "Golec 2018, Eq. 4.4 and Table 4.2";
  own.covers =
      "the cells that mss-cf covers; "
      "the laws of liver, kidney and spleen, to which limits were fitted by hand; "
      "loads without inertia, and no limits of paths";
  own.cells = {CellType::hexahedron};
  own.solvers = {Solver::static_equilibrium};
  own.solve = [elongation](const CaseSettings& settings, const Mesh& mesh,
                           const Scene& scene, int /*threads*/,
                           const dynamics::Observers& observers) {
    return solve_thesis_springs(elongation, settings, mesh, scene, observers);
  };
  return of_tissue(std::move(own));
}

}  // namespace

std::vector<Method> tissue_methods() {
  const std::vector<CellType> any_cells(all_cell_types.begin(), all_cell_types.end());
  constexpr std::string_view law =
      "Golec 2018, Eq. 4.1, on branches after Green and Tobolsky 1946 and Simo 1987";
  return {
      of_tissue({.name = "mss-tissue",
                 .description =
                     "springs that remember, of a bi-power law (options --organ, --law)",
                 .source = law,
                 .family = Family::springs,
                 .look = {"#7A0177", "*"},
                 .reads = {"branches"},
                 .covers = "cells of any shape; no limits of paths, which give way with "
                           "time; no implicit steps",
                 .cells = any_cells,
                 .solvers = {Solver::static_equilibrium, Solver::explicit_euler,
                             Solver::semi_implicit_euler, Solver::verlet},
                 .solve = solve_by_springs,
                 .stepping = stepping_of_springs,
                 .seconds = {.in_motion = 0.03, .in_motion_off_grids = 0.03}}),
      of_tissue(
          {.name = "fem-tissue",
           .description = "finite elements of the same law, with a memory at 2x2x2 "
                          "points; without inertia",
           .source = law,
           .family = Family::finite_elements,
           .look = {"#4D4D4D", "1"},
           .reads = {"branches"},
           .covers = "cells of any shape; loads without inertia, and no limits of paths",
           .cells = any_cells,
           .solvers = {Solver::static_equilibrium},
           .solve = solve_by_elements}),
      of_thesis(
          tissue::Elongation::in_metres,
          {.name = "mss-thesis-tissue",
           .description =
               "springs of Golec 2018, Eq. 4.4, as printed, with hand-fitted limits",
           .look = {"#C2A5CF", "2"}}),
      of_thesis(tissue::Elongation::relative,
                {.name = "mss-thesis-tissue-relative",
                 .description = "the same, elongations over the rest length: a force of "
                                "any unit of length",
                 .look = {"#A6761D", "3"}})};
}

std::string extrapolation(const tissue::FitRange& range, const Dynamics& dynamics,
                          double largest_strain) {
  std::vector<std::string> said;
  const auto say = [&](std::string what) { said.push_back(std::move(what)); };
  const auto text = [&] {
    return said.empty() ? ""
                        : fmt::format("extrapolated beyond the fitted range: {}",
                                      fmt::join(said, ", "));
  };
  if (largest_strain > range.strains.to * (1 + 1e-9))  // round-off
    say(fmt::format("shear strains of {:.4g} (fitted to {:g})", largest_strain,
                    range.strains.to));
  constexpr double leeway = 1.1;
  const bool is_small = largest_strain < range.strains.from;
  if (is_small && dynamics.oscillation) {
    if (!range.angular_frequencies.contains(dynamics.oscillation->angular_frequency))
      say(fmt::format("{:g} rad/s (fitted from {:g} to {:g})",
                      dynamics.oscillation->angular_frequency,
                      range.angular_frequencies.from, range.angular_frequencies.to));
    return text();
  }
  const Pace pace = pace_of(dynamics);
  if (pace.longest_hold > leeway * range.times_held.to)
    say(fmt::format("a hold of {:.4g} s (fitted to {:g} s)", pace.longest_hold,
                    range.times_held.to));
  if (is_small) {  // linear: what counts is the time alone
    const double least = 1 / range.angular_frequencies.to;
    if (pace.shortest_way * leeway < least)
      say(fmt::format("a small strain within {:.3g} s (fitted from {:g} s)",
                      pace.shortest_way, least));
    return text();
  }
  const double of_load = largest_strain / pace.largest_fraction;
  for (const double rate : {pace.slowest * of_load, pace.fastest * of_load}) {
    if (rate * leeway >= range.rates.from && rate <= leeway * range.rates.to) continue;
    say(fmt::format("rates of {:.3g} 1/s (fitted from {:g} to {:g})", rate,
                    range.rates.from, range.rates.to));
    break;
  }
  return text();
}

}  // namespace springcheck
