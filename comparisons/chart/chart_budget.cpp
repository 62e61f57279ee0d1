// What a chart's budget and the machine's memory allow.

#include <algorithm>
#include <cmath>

#include "comparisons/chart/chart_run.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"

namespace springcheck {
namespace {

/// The model without what solves its equations.
Model without_solver(Model model) {
  model.linear_solver.clear();
  return model;
}

}  // namespace

double ChartRun::expected_seconds(const ChartModel& model, int across) {
  const CaseSettings settings = settings_of(model, across);
  if (!fits_in_memory(settings)) return INFINITY;
  const Mesh& mesh = meshes_.mesh(settings.body);
  return expected_seconds(model, static_cast<double>(mesh.nodes().size()),
                          plan_.threads.front());
}

double ChartRun::expected_seconds(const ChartModel& model, double nodes,
                                  int threads) const {
  std::map<double, double> smaller, failed;  // seconds by nodes
  for (const StoredChart::Point& other : chart_.points)
    if (other.model == model.model && other.threads == threads && other.nodes < nodes &&
        other.timing)
      (has_failed(other.key) ? failed : smaller)[other.nodes] = other.timing->median;
  return springcheck::expected_seconds(smaller.empty() ? failed : smaller, nodes);
}

void ChartRun::measure_beyond_budget(std::span<const ChartModel> models) {
  const auto wanted = static_cast<std::size_t>(plan_.least_models);
  const int finest = plan_.across.back();
  std::vector<const ChartModel*> candidates;
  std::vector<Model> reached;
  const auto is_reached = [&](const ChartModel& model) {
    return std::ranges::count(reached, without_solver(model.model)) > 0;
  };
  const auto reach = [&](const ChartModel& model) {
    if (!is_reached(model)) reached.push_back(without_solver(model.model));
  };
  for (const ChartModel& model : models) {
    if (model.kind != ChartKind::equilibrium) continue;
    if (is_ok(model, finest))
      reach(model);
    else if (next_size(model) && !fails_somewhere(model) &&
             fits_in_memory(settings_of(model, finest)))
      candidates.push_back(&model);
  }
  Progress progress(plan_.scene + ": models on the finest cells");
  while (true) {
    std::erase_if(candidates,
                  [&](const ChartModel* model) { return is_reached(*model); });
    if (reached.size() >= wanted || candidates.empty()) return;
    progress.show(reached.size(), wanted);
    const auto cheapest = std::ranges::min_element(
        candidates, {},
        [&](const ChartModel* model) { return expected_seconds(*model, finest); });
    const ChartModel& model = **cheapest;
    const int across = next_size(model).value();
    measure(model, across, {&plan_.threads.front(), 1}, INFINITY);
    if (is_ok(model, finest)) reach(model);
    // What fails gets no finer: how long that takes no coarser mesh tells.
    if (!is_ok(model, across)) candidates.erase(cheapest);
  }
}

bool ChartRun::is_timed(const ChartModel& model, int across) {
  const StoredChart::Point* const point = find_point(
      chart_, model.model, key_of(settings_of(model, across)), plan_.threads.front());
  return point != nullptr && point->timing;
}

bool ChartRun::is_ok(const ChartModel& model, int across) {
  const auto found = outcomes_.find(key_of(settings_of(model, across)));
  return is_timed(model, across) && found != outcomes_.end() && found->second.is_ok;
}

bool ChartRun::fails_somewhere(const ChartModel& model) {
  return std::ranges::any_of(plan_.across, [&](int across) {
    return is_timed(model, across) && !is_ok(model, across);
  });
}

std::optional<int> ChartRun::next_size(const ChartModel& model) {
  const auto size = std::ranges::find_if_not(
      plan_.across, [&](int across) { return is_timed(model, across); });
  return size == plan_.across.end() ? std::nullopt : std::optional(*size);
}

}  // namespace springcheck
