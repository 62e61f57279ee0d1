#include "comparisons/chart/chart_truth.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/chart/chart_models.hpp"
#include "comparisons/measures/measures.hpp"

namespace springcheck {
namespace {

struct OnGrids {
  std::array<double, 3> answers{}, volumes{};
};

/// The figures on the three grids; none where a case failed, or is not in the file.
std::optional<OnGrids> figures_of(const StoredChart::Grids& grids,
                                  const std::string& answer,
                                  const std::map<std::string, StoredCase>& cases) {
  OnGrids figures;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto grid = cases.find(grids.keys[i]);
    if (grid == cases.end() || grid->second.status != Status::ok) return std::nullopt;
    const Measures& measures = grid->second.measures;
    const auto own_answer = measure_of(measures, answer);
    if (!own_answer) return std::nullopt;
    figures.answers[i] = *own_answer;
    figures.volumes[i] = measures.volume_change.value();
  }
  return figures;
}

/// A number of the truth. Changes below `unit` times solver_noise are the solvers'.
CheckedNumber number_of(const StoredChart::Truth& truth,
                        const std::array<double, 3>& values,
                        const std::optional<std::array<double, 3>>& check, double unit) {
  const auto limit = [&](const StoredChart::Grids& grids,
                         const std::array<double, 3>& on_grids) {
    return converged_number(grids.cell_sizes, on_grids, solver_noise * unit,
                            grids.formal_order);
  };
  const ConvergedNumber number = limit(truth.grids, values);
  if (!check)
    return {
        .value = number.value, .order = number.order, .error_bound = number.error_bound};
  return checked_number(number, limit(*truth.check, *check));
}

}  // namespace

const std::optional<double>& ChartErrors::of(ChartMeasure measure) const {
  switch (measure) {
    case ChartMeasure::volume:
      return volume;
    case ChartMeasure::deviation:
      return deviation;
    case ChartMeasure::force:
      break;
  }
  return force;
}

std::string_view element_of(const CheckedNumber& number) {
  return number.is_of_check ? check_element : truth_element;
}

std::optional<ChartTruth> truth_of(const StoredChart& chart,
                                   const StoredChart::Truth& grids,
                                   const std::map<std::string, StoredCase>& cases) {
  const auto figures = figures_of(grids.grids, chart.answer, cases);
  if (!figures) return std::nullopt;
  const auto check =
      grids.check ? figures_of(*grids.check, chart.answer, cases) : std::nullopt;
  ChartTruth truth{
      .grids = grids,
      .answer = number_of(grids, figures->answers,
                          check ? std::optional(check->answers) : std::nullopt,
                          std::abs(figures->answers[2])),
      .volume_change = number_of(grids, figures->volumes,
                                 check ? std::optional(check->volumes) : std::nullopt, 1),
      .imposed = 0};
  truth.imposed = chart.imposed.value_or(std::abs(truth.answer.value));
  truth.error_bounds.force = truth.answer.error_bound / std::abs(truth.answer.value);
  truth.error_bounds.volume =
      truth.volume_change.error_bound / (truth.imposed / chart.height);
  return truth;
}

std::optional<double> apart_in_places(std::span<const CaseResult* const> grids,
                                      std::span<const CaseResult* const> check,
                                      MeshStore& meshes) {
  const CaseSettings& settings = grids.front()->request.settings;
  const Mesh& mesh = meshes.mesh(settings.body);
  const auto one = reference_field({.settings = settings}, grids, meshes),
             other = reference_field({.settings = settings}, check, meshes);
  if (!one || !other) return std::nullopt;
  const auto relative = [&](const std::vector<double>& distances) {
    return reference_bar_l2_relative(settings, mesh, one->solution, distances);
  };
  std::vector<double> distances;
  for (std::size_t n = 0; n < mesh.nodes().size(); ++n)
    distances.push_back(
        (one->solution.displacements[n] - other->solution.displacements[n]).norm());
  const auto apart = relative(distances), own_bound = relative(one->node_error_bounds),
             other_bound = relative(other->node_error_bounds);
  if (!apart) return std::nullopt;
  return *apart <= *own_bound + *other_bound ? *apart : *apart + *other_bound;
}

}  // namespace springcheck
