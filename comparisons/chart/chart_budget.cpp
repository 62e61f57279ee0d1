// What a chart's budget and the machine's memory allow.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparisons/chart/chart_run.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"
#include "comparisons/settings/case_json.hpp"
#include "comparisons/system/memory.hpp"

namespace springcheck {
namespace {

constexpr double growth_of_paths = 1.5;  // exponent of the nodes

/// The model without what solves its equations.
Model without_solver(Model model) {
  model.linear_solver.clear();
  return model;
}

}  // namespace

double ChartRun::expected_seconds(const ChartModel& model, int across) {
  const CaseSettings settings = settings_of(model, across);
  if (!fits(settings)) return INFINITY;
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

StaticPath ChartRun::static_path(const ChartModel& model, int across) {
  const auto& solvers = find_method(model.model.method)->solvers;
  if (std::ranges::find(solvers, Solver::path_limit) == solvers.end())
    return {.was_followed = true};
  CaseSettings settings = settings_of(model, across);
  settings.solver = Solver::path_limit;
  // The same of both precisions, and of rest and motion.
  const std::string key = settings_json(settings).dump();
  if (const auto known = paths_.find(key); known != paths_.end()) return known->second;
  const StaticPath coarser =
      across > 2 ? static_path(model, std::max(2, across * 2 / 3)) : StaticPath{};
  const Mesh& mesh = meshes_.mesh(settings.body);
  StaticPath path{.nodes = static_cast<double>(mesh.nodes().size())};
  if (coarser.nodes > 0)
    path.seconds =
        coarser.seconds * std::pow(path.nodes / coarser.nodes, growth_of_paths);
  if (path.seconds <= plan_.budget && fits(settings)) {
    const CaseResult result = simulate(settings, mesh);
    path.was_followed = true;
    // Of the whole load, for finer cells, which may get farther.
    constexpr double least = 0.01;
    path.seconds =
        result.solve_wall_s / std::clamp(result.solution.load_fraction, least, 1.);
    if (result.status != Status::ok)
      path.against =
          result.reason.empty() ? std::string(name_of(result.status)) : result.reason;
  }
  return paths_[key] = path;
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
             fits(settings_of(model, finest)))
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

bool ChartRun::fits(const CaseSettings& settings) {
  return estimated_memory(settings) <= available_memory();
}

}  // namespace springcheck
