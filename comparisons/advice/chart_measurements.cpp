#include "comparisons/advice/chart_measurements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/measures/displacement_norms.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/running/cost.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"
#include "comparisons/running/simulate.hpp"
#include "comparisons/settings/case_json.hpp"

namespace springcheck {
namespace {

constexpr double growth_of_paths = 1.5;  // exponent of the nodes

/// Says what is about to be computed: the three grids of the truth.
const ChartPlan& announced(const ChartPlan& plan) {
  CostEstimate cost;
  std::string sizes;
  const ThreeCases grids = planned_truths(plan).front();
  for (const CaseSettings& grid : grids) {
    cost.add({.settings = grid});
    sizes += fmt::format("{}{}", sizes.empty() ? "" : ", ",
                         fmt::format("{}x{}x{}", grid.body.block.cells[0],
                                     grid.body.block.cells[1], grid.body.block.cells[2]));
  }
  announce(fmt::format(
      "the truth, {}:q2 on {} cells: about {:.0f} s, where it is not kept already",
      grids.front().method.name, sizes, cost.seconds()));
  return plan;
}

bool is_nested(const Body& body) {
  return body.shape == BodyShape::block;
}

double imposed_by(const CaseSettings& grid, const Mesh& mesh, double answer) {
  if (grid.test == Test::bending) return std::abs(answer);
  return largest_imposed_displacement(mesh, mechanical_scene(grid, mesh));
}

}  // namespace

ChartMeasurements::ChartMeasurements(const ChartPlan& plan,
                                     const std::filesystem::path& file)
    : plan_(plan), run_(announced(plan), file) {
  for (const Neighbour& neighbour : neighbours_of(run_.own_truth().front()))
    beside_.push_back({.neighbour = neighbour});
}

void ChartMeasurements::measure(const ChartModel& model, int across) {
  if (across > finest_across_) announce(fmt::format("models on {} cells across", across));
  finest_across_ = std::max(finest_across_, across);
  run_.measure(model, across);
}

StaticPath ChartMeasurements::static_path(const ChartModel& model, int across) {
  const auto& solvers = find_method(model.model.method)->solvers;
  if (std::ranges::find(solvers, Solver::path_limit) == solvers.end())
    return {.was_followed = true};
  CaseSettings settings = model_case(plan_.scene, plan_.options, model, across);
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
  if (path.seconds <= plan_.budget && fits_in_memory(settings)) {
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

std::size_t ChartMeasurements::scenes_beside(const ChartModel& model) {
  if (!find_method(model.model.method)->own_poisson_ratio) return beside_.size();
  const double nu = run_.own_truth().front().material.poisson_ratio;
  return static_cast<std::size_t>(std::ranges::count_if(
      beside_, [&](const Known& scene) { return scene.neighbour.poisson_ratio == nu; }));
}

BesideScene ChartMeasurements::beside(std::size_t scene, const ChartModel& model,
                                      int across) {
  Known& known = beside_[scene];
  if (!known.was_asked_for) find_truth_of(known);
  BesideScene shown{.where = name_of(known.neighbour)};
  if (!known.truth) return shown;
  Request request{.settings = moved(model_case(plan_.scene, plan_.options, model, across),
                                    known.neighbour)};
  if (is_nested(request.settings.body)) request.reference = known.grid;
  const CaseResult result = run_.result_of(request);
  shown.has_truth = true;
  shown.status = result.status;
  shown.errors = beyond_bars(errors_of(run_.stored(), *known.truth, result.measures,
                                       request.reference ? &result.measures : nullptr),
                             known.truth->bars);
  return shown;
}

void ChartMeasurements::find_truth_of(Known& scene) {
  scene.was_asked_for = true;
  const CaseSettings& grid = run_.own_truth()[1];
  scene.grid = moved(grid, scene.neighbour);
  announce(fmt::format("what holds {}: {}:q2 there", name_of(scene.neighbour),
                       grid.method.name));
  run_.find_references({scene.grid});
  const CaseResult here = run_.result_of({.settings = grid}),
                   there = run_.result_of({.settings = scene.grid});
  if (there.status != Status::ok) return;
  const Chart known = chart();
  const ChartTruth& truth = known.truths[known.truth_of(known.stored.law).value()];
  const double answer = measure_of(there.measures, known.stored.answer).value();
  scene.truth = carried_truth(
      truth, known.stored.answer, here.measures, there.measures,
      imposed_by(scene.grid, meshes_.mesh(scene.grid.body), answer), deviation_of_grid());
}

std::optional<double> ChartMeasurements::deviation_of_grid() {
  const ThreeCases& grids = run_.own_truth();
  if (!is_nested(grids[1].body)) return std::nullopt;
  return run_
      .result_of({.settings = grids[1],
                  .reference = grids[0],
                  .reference_grid = ReferenceGrid::converged})
      .measures.deviation_l2_relative;
}

bool ChartMeasurements::refine_truth() {
  CaseSettings coarser = run_.own_truth().front();
  if (!is_nested(coarser.body)) return false;
  for (int& cells : coarser.body.block.cells) {
    if (cells % 2 != 0) return false;
    cells /= 2;
  }
  const CaseResult result = run_.result_of({.settings = coarser});
  if (result.status != Status::ok) return false;
  const Chart known = run_.chart();
  const ChartTruth& truth = known.truths[known.truth_of(known.stored.law).value()];
  std::array<CaseResult, 2> finer{run_.result_of({.settings = run_.own_truth()[0]}),
                                  run_.result_of({.settings = run_.own_truth()[1]})};
  const auto bar_of = [&](const auto& value_of, const ConvergedNumber& limit,
                          double noise) {
    const ThreeCases coarse{coarser, run_.own_truth()[0], run_.own_truth()[1]};
    return bar_by_fourth_grid(
        converged_number(coarse,
                         {value_of(result.measures), value_of(finer[0].measures),
                          value_of(finer[1].measures)},
                         noise),
        limit);
  };
  const double answer = std::abs(truth.answer.value);
  refined_bars_.force =
      bar_of([&](const Measures& m) { return *measure_of(m, known.stored.answer); },
             truth.answer, solver_noise * answer) /
      answer;
  refined_bars_.volume =
      bar_of([&](const Measures& m) { return m.volume_change.value(); },
             truth.volume_change, solver_noise) /
      (truth.imposed / known.stored.height);
  return true;
}

Chart ChartMeasurements::chart() const {
  Chart chart = run_.chart();
  if (const auto own = chart.truth_of(chart.stored.law)) {
    ChartErrors& bars = chart.truths[*own].bars;
    if (refined_bars_.force) bars.force = refined_bars_.force;
    if (refined_bars_.volume) bars.volume = refined_bars_.volume;
  }
  return chart;
}

}  // namespace springcheck
