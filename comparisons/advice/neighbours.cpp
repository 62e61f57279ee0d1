#include "comparisons/advice/neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace springcheck {
namespace {

bool has_load(const CaseSettings& settings, double load) {
  if (!settings.deformation) return true;
  const double deformation = std::abs(load * *settings.deformation);
  if (entry_of(settings.test).turns) return deformation <= 2 * std::numbers::pi;
  const bool only_pulls =
      settings.test == Test::tension || settings.test == Test::shearing;
  return only_pulls || deformation < 1;
}

std::optional<double> beyond(const std::optional<double>& error,
                             const std::optional<double>& bar) {
  if (!error) return std::nullopt;
  return std::max(0., *error - bar.value_or(0));
}

}  // namespace

std::string name_of(const Neighbour& neighbour) {
  return neighbour.load != 1 ? fmt::format("at {:g} times the load", neighbour.load)
                             : fmt::format("at nu = {:.4g}", neighbour.poisson_ratio);
}

std::vector<Neighbour> neighbours_of(const CaseSettings& settings) {
  constexpr double aside = 0.02;
  const double nu = settings.material.poisson_ratio;
  std::vector<Neighbour> all;
  for (const double load : {0.8, 1.2})
    if (has_load(settings, load)) all.push_back({.load = load, .poisson_ratio = nu});
  if (nu - aside > -1) all.push_back({.poisson_ratio = nu - aside});
  all.push_back({.poisson_ratio = std::min(nu + aside, (nu + 0.5) / 2)});
  return all;
}

CaseSettings moved(CaseSettings settings, const Neighbour& neighbour) {
  if (settings.deformation) *settings.deformation *= neighbour.load;
  settings.gravity *= neighbour.load;
  settings.material.poisson_ratio = neighbour.poisson_ratio;
  return settings;
}

ChartTruth carried_truth(const ChartTruth& truth, const std::string& answer,
                         const Measures& grid, const Measures& grid_there,
                         double imposed_there, std::optional<double> deviation) {
  ChartTruth there = truth;
  there.answer.value *=
      measure_of(grid_there, answer).value() / measure_of(grid, answer).value();
  there.imposed = imposed_there;
  there.volume_change.value = grid_there.volume_change.value() +
                              (truth.volume_change.value - grid.volume_change.value()) *
                                  imposed_there / truth.imposed;
  there.bars.deviation = deviation;
  return there;
}

ChartErrors beyond_bars(const ChartErrors& errors, const ChartErrors& bars) {
  return {.force = beyond(errors.force, bars.force),
          .volume = beyond(errors.volume, bars.volume),
          .deviation = beyond(errors.deviation, bars.deviation)};
}

}  // namespace springcheck
