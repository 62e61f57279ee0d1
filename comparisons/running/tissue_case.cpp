#include "comparisons/running/tissue_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fem_reference/tissue/solve_tissue.hpp"
#include "meshing/stopwatch.hpp"
#include "mss/tissue/solve_tissue.hpp"
#include "mss/tissue/thesis_springs.hpp"

namespace springcheck {
namespace {

Solution solved(const CaseSettings& settings, const Mesh& mesh, const Scene& scene,
                const mss::TissueSettings& tissue, const dynamics::Observers& observers) {
  if (std::get<TissueModel>(settings.method.model) == TissueModel::springs)
    return mss::solve_tissue(mesh, scene, tissue, observers);
  if (tissue.protocol)
    return refused("fem-tissue goes through equilibria; mss-tissue moves");
  return fem_reference::solve_tissue(mesh, scene, tissue.solid, tissue.quasi_static,
                                     observers);
}

dynamics::LoadPath load_of(const Dynamics& dynamics) {
  return dynamics.load.empty() ? dynamics::ramp(dynamics.duration) : dynamics.load;
}

/// Table 4.2 has no limit but of the organs of Table 4.1.
std::optional<double> limit_fitted_by_hand(const tissue::BipowerLaw& law) {
  for (const tissue::Organ& organ : tissue::organs())
    if (organ.law == law) return tissue::hand_fitted_limit(organ.name);
  return std::nullopt;
}

Solution solve_thesis_tissue(const CaseSettings& settings, const Mesh& mesh,
                             const Scene& scene,
                             const dynamics::QuasiStaticSettings& quasi_static,
                             const dynamics::Observers& observers) {
  const tissue::BipowerLaw& law = settings.tissue.law;
  if (goes_through_time(settings))
    return refused("Eq. 4.4's dashpots have no constant: there is no motion of it");
  const auto limit = limit_fitted_by_hand(law);
  if (!limit)
    return refused("Golec 2018 fitted limits by hand, to liver, kidney and spleen alone");
  const bool is_printed =
      std::get<TissueModel>(settings.method.model) == TissueModel::thesis_springs;
  return mss::move_thesis_springs(
      mesh, scene,
      {.law = law,
       .strain_limit = *limit,
       .elongation =
           is_printed ? tissue::Elongation::in_metres : tissue::Elongation::relative},
      quasi_static, observers);
}

}  // namespace

Solution solve_tissue(const CaseSettings& settings, const Mesh& mesh, const Scene& scene,
                      const dynamics::Protocol& protocol, int threads,
                      const dynamics::Observers& observers) {
  const auto& [law, branches, steps] = settings.tissue;
  const dynamics::QuasiStaticSettings quasi_static{.load = load_of(settings.dynamics),
                                                   .steps = steps};
  if (solver_of(settings) == Solver::path_limit)
    return refused("tissue has no limit: it gives way with time");
  if (is_thesis_tissue(settings.method))
    return solve_thesis_tissue(settings, mesh, scene, quasi_static, observers);
  const Stopwatch stopwatch;
  const tissue::MaxwellFit fit = tissue::fit_maxwell_model(law, {}, branches);
  const double fit_wall_s = stopwatch.seconds();
  Solution solution = solved(
      settings, mesh, scene,
      {.solid = {.shear = fit.model,
                 .bulk_ratio = tissue::bulk_ratio_of(settings.material.poisson_ratio)},
       .quasi_static = quasi_static,
       .protocol = goes_through_time(settings) ? std::optional(protocol) : std::nullopt,
       .threads = threads},
      observers);
  solution.setup_wall_s += fit_wall_s;
  if (!solution.largest_shear_strain) return solution;
  const std::string beyond =
      extrapolation(fit.range, settings.dynamics, *solution.largest_shear_strain);
  if (!beyond.empty()) solution.reason += (solution.reason.empty() ? "" : "; ") + beyond;
  return solution;
}

std::string extrapolation(const tissue::FitRange& range, const Dynamics& dynamics,
                          double largest_strain) {
  std::string text;
  const auto say = [&](const std::string& what) {
    text += (text.empty() ? "extrapolated beyond the fitted range: " : ", ") + what;
  };
  if (largest_strain > range.strains.to * (1 + 1e-9))  // round-off
    say(fmt::format("shear strains of {:.3g} (fitted to {:g})", largest_strain,
                    range.strains.to));
  if (largest_strain < range.strains.from) {
    if (dynamics.oscillation &&
        !range.angular_frequencies.contains(dynamics.oscillation->angular_frequency))
      say(fmt::format("{:g} rad/s (fitted from {:g} to {:g})",
                      dynamics.oscillation->angular_frequency,
                      range.angular_frequencies.from, range.angular_frequencies.to));
    return text;
  }
  double largest_fraction = 0, slowest = INFINITY, fastest = 0;
  dynamics::LoadPoint from{.time = 0, .fraction = 0};
  for (const dynamics::LoadPoint& to : dynamics::turning_points(load_of(dynamics))) {
    largest_fraction = std::max(largest_fraction, std::abs(to.fraction));
    const double rate = std::abs(to.fraction - from.fraction) / (to.time - from.time);
    if (rate > 0) slowest = std::min(slowest, rate);
    fastest = std::max(fastest, rate);
    from = to;
  }
  constexpr double leeway = 1.1;
  const double of_load = largest_strain / largest_fraction;
  for (const double rate : {slowest * of_load, fastest * of_load}) {
    if (rate * leeway >= range.rates.from && rate <= leeway * range.rates.to) continue;
    say(fmt::format("rates of {:.3g} 1/s (fitted from {:g} to {:g})", rate,
                    range.rates.from, range.rates.to));
    break;
  }
  return text;
}

}  // namespace springcheck
