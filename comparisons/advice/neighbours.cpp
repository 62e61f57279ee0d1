#include "comparisons/advice/neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace springcheck {
namespace {

bool has_load(Test test, double deformation) {
  if (test == Test::compression) return std::abs(deformation) < 1;
  return test != Test::uniaxial || deformation > -1;
}

std::optional<double> beyond(const std::optional<double>& error,
                             const std::optional<double>& error_bound) {
  if (!error) return std::nullopt;
  return std::max(0., *error - error_bound.value_or(0));
}

}  // namespace

std::string name_of(const Neighbour& neighbour) {
  return neighbour.load != 1 ? fmt::format("at {:g} times the load", neighbour.load)
                             : fmt::format("at nu = {:.9g}", neighbour.poisson_ratio);
}

std::vector<Neighbour> neighbours_of(const CaseSettings& settings) {
  constexpr double aside = 0.02;
  const double nu = settings.material.poisson_ratio;
  std::vector<Neighbour> all{{.load = 0.8, .poisson_ratio = nu},
                             {.load = 1.2, .poisson_ratio = nu}};
  if (nu - aside > -1) all.push_back({.poisson_ratio = nu - aside});
  all.push_back({.poisson_ratio = std::min(nu + aside, (nu + 0.5) / 2)});
  return all;
}

std::optional<CaseSettings> moved(CaseSettings settings, const Neighbour& neighbour) {
  if (settings.deformation) *settings.deformation *= neighbour.load;
  if (settings.deformation && !has_load(settings.test, *settings.deformation))
    return std::nullopt;
  settings.gravity *= neighbour.load;
  settings.material.poisson_ratio = neighbour.poisson_ratio;
  return settings;
}

ChartTruth carried_truth(const ChartTruth& truth, const StoredChart& chart,
                         const TwoGrids& here, const TwoGrids& there,
                         const std::optional<double>& imposed,
                         const std::optional<double>& deviation) {
  const auto by = [&](std::size_t grid) {
    ChartTruth carried = truth;
    carried.answer.value *= measure_of(there[grid], chart.answer).value() /
                            measure_of(here[grid], chart.answer).value();
    carried.imposed = imposed.value_or(std::abs(carried.answer.value));
    carried.volume_change.value =
        there[grid].volume_change.value() +
        (truth.volume_change.value - here[grid].volume_change.value()) * carried.imposed /
            truth.imposed;
    return carried;
  };
  ChartTruth carried = by(1);
  const ChartTruth by_coarser = by(0);
  const auto add = [](std::optional<double>& error_bound, double more) {
    error_bound = error_bound.value_or(0) + std::abs(more);
  };
  add(carried.error_bounds.force, by_coarser.answer.value / carried.answer.value - 1);
  add(carried.error_bounds.volume,
      (by_coarser.volume_change.value - carried.volume_change.value) /
          (carried.imposed / chart.height));
  carried.error_bounds.deviation = deviation;
  return carried;
}

ChartErrors beyond_error_bounds(const ChartErrors& errors,
                                const ChartErrors& error_bounds) {
  return {.force = beyond(errors.force, error_bounds.force),
          .volume = beyond(errors.volume, error_bounds.volume),
          .deviation = beyond(errors.deviation, error_bounds.deviation)};
}

}  // namespace springcheck
