#include "comparisons/advice/chart_measurements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/measures/displacement_norms.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/running/cost.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/running/progress.hpp"
#include "comparisons/running/simulate.hpp"
#include "comparisons/settings/case_json.hpp"
#include "comparisons/studies/split.hpp"

namespace springcheck {
namespace {

constexpr double growth_of_paths = 1.5;  // exponent of the nodes

/// The grids as text: "fem-stvk:q2 on 4x4x4, 8x8x8, 16x16x16 cells".
std::string text_of(const ThreeCases& grids) {
  const CaseSettings& first = grids.front();
  std::string text =
      fmt::format("{}:{} on ", first.method.name, first.elements.element.name);
  for (const CaseSettings& grid : grids)
    text += fmt::format("{}{}", &grid == &first ? "" : ", ",
                        fmt::join(grid.body.block.cells, "x"));
  return text + " cells";
}

/// Says what is about to be computed: the grids of the truth.
const ChartPlan& announced(const ChartPlan& plan) {
  CostEstimate cost;
  const TruthGrids truth = planned_truths(plan).front();
  for (const ThreeCases& grids : {truth.grids, truth.check})
    for (const CaseSettings& grid : grids) cost.add({.settings = grid});
  announce(fmt::format(
      "the converged solution, {}, checked by {}: about {:.0f} s, where it is not "
      "kept already",
      text_of(truth.grids), text_of(truth.check), cost.seconds()));
  return plan;
}

/// The law that a model's springs or elements have, by q2 on that grid; none where it is
/// not known.
std::optional<CaseSettings> law_of(const CaseSettings& model, const CaseSettings& grid) {
  const Method& method = model.method;
  const bool is_of_its_cells =
      !method.lattice || !method.lattice->of_cubes || is_grid_of_cubes(model.body);
  CaseSettings law = model;
  if (method.lattice && is_of_its_cells)
    law = continuum_of(model);
  else
    law.method = at_rest(method);
  if (!reads(law.method, "element")) return std::nullopt;
  law.body = grid.body;
  law.elements.element = grid.elements.element;
  law.search.linear_solver = grid.search.linear_solver;
  return law;
}

}  // namespace

ChartMeasurements::ChartMeasurements(const ChartPlan& plan,
                                     const std::filesystem::path& file)
    : plan_(plan), run_(announced(plan), file) {
  for (std::size_t i = 0; i < figures_.size(); ++i) {
    const CaseSettings& grid = run_.own_truth()[i];
    const CaseResult result = run_.result_of({.settings = grid});
    if (result.status != Status::ok)
      throw std::runtime_error(fmt::format(
          "{}: no converged solution to hold a model against: {}:q2 is {} on {} "
          "cells{}{}. Other grids are taken by --converged-across, another law by "
          "--converged-law",
          plan.scene, grid.method.name, name_of(result.status),
          fmt::join(grid.body.block.cells, "x"), result.reason.empty() ? "" : ": ",
          result.reason));
    figures_[i] = result.measures;
  }
  const Chart chart = run_.chart();
  own_truth_ = chart.truths[chart.truth_of(chart.stored.law).value()];
  for (const Neighbour& neighbour : neighbours_of(run_.own_truth().front()))
    beside_.push_back({.neighbour = neighbour});
}

void ChartMeasurements::measure(const ChartModel& model, int across, double seconds) {
  if (across > finest_across_) announce(fmt::format("models on {} cells across", across));
  finest_across_ = std::max(finest_across_, across);
  run_.measure(model, across, seconds);
}

void ChartMeasurements::time_again(const ChartModel& model, int across) {
  for (int round = 2; round <= most_rounds; ++round)
    run_.time_again(model, across, round);
}

StaticPath ChartMeasurements::static_path(const ChartModel& model, int across) {
  const auto& solvers = find_method(model.model.method)->solvers;
  if (std::ranges::find(solvers, Solver::path_limit) == solvers.end())
    return {.was_followed = true};
  CaseSettings settings = model_case(plan_.scene, plan_.options, model, across);
  settings.solver = Solver::path_limit;
  settings.search.linear_solver = statics::LinearSolver::automatic;
  // The key is the same for all linear solvers, both precisions, and rest and motion.
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
    // The time is extrapolated to the whole load, for finer cells, which may get farther.
    constexpr double least = 0.01;
    path.seconds = result.measures.solve_wall_s.value() /
                   std::clamp(result.solution.load_fraction, least, 1.);
    if (result.status != Status::ok)
      path.against =
          result.reason.empty() ? std::string(name_of(result.status)) : result.reason;
  }
  return paths_[key] = path;
}

std::optional<ChartErrors> ChartMeasurements::law_errors(const ChartModel& model,
                                                         int across) {
  const CaseSettings& grid = run_.own_truth()[1];
  const auto law = law_of(model_case(plan_.scene, plan_.options, model, across), grid);
  if (!law) return std::nullopt;
  if (law->method.name == grid.method.name &&
      law->method.name != continuum_of_lattices().name)
    return ChartErrors{.force = 0, .volume = 0, .deviation = 0};
  const std::string key = settings_json(*law).dump();
  if (const auto known = law_errors_.find(key); known != law_errors_.end())
    return known->second;
  announce(
      fmt::format("what {} converges to: {}:q2", name_of(model.model), law->method.name));
  Request request{.settings = *law};
  if (is_nested(grid.body)) request.reference = grid;
  const CaseResult result = run_.result_of(request);
  if (result.status != Status::ok) return law_errors_[key] = std::nullopt;
  ChartTruth by_grid = own_truth_;
  by_grid.answer.value = measure_of(figures_[1], run_.stored().answer).value();
  by_grid.volume_change.value = figures_[1].volume_change.value();
  return law_errors_[key] = errors_of(run_.stored(), by_grid, result.measures,
                                      request.reference ? &result.measures : nullptr);
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
  const auto settings =
      moved(model_case(plan_.scene, plan_.options, model, across), known.neighbour);
  if (!known.has_truth || !settings) return shown;
  Request request{.settings = *settings};
  if (is_nested(settings->body)) request.reference = known.grid;
  const std::string key = settings_json(*settings).dump();
  if (!known.results.contains(key)) {
    const CaseResult result = run_.result_of(request);
    known.results[key] = {result.status, result.measures};
  }
  const auto& [status, measures] = known.results[key];
  const ChartTruth truth = truth_of(known);
  shown.has_truth = true;
  shown.status = status;
  shown.errors = beyond_error_bounds(
      errors_of(run_.stored(), truth, measures, request.reference ? &measures : nullptr),
      truth.error_bounds);
  return shown;
}

void ChartMeasurements::find_truth_of(Known& scene) {
  scene.was_asked_for = true;
  const ThreeCases& grids = run_.own_truth();
  announce(fmt::format("what holds {}: {}:q2 there", name_of(scene.neighbour),
                       grids[1].method.name));
  for (std::size_t i = 0; i < 2; ++i) {
    scene.grid = moved(grids[i], scene.neighbour);
    if (!scene.grid) return;
    run_.find_references({*scene.grid});
    const CaseResult there = run_.result_of({.settings = *scene.grid});
    if (there.status != Status::ok) return;
    scene.figures[i] = there.measures;
  }
  if (scene.grid->test != Test::bending) {
    const Mesh& mesh = meshes_.mesh(scene.grid->body);
    scene.imposed =
        largest_imposed_displacement(mesh, mechanical_scene(*scene.grid, mesh));
  }
  scene.has_truth = true;
}

ChartTruth ChartMeasurements::truth_of(const Known& scene) {
  return carried_truth(own_truth_, run_.stored(), {figures_[0], figures_[1]},
                       scene.figures, scene.imposed, deviation_of_grid());
}

const std::optional<double>& ChartMeasurements::deviation_of_grid() {
  const ThreeCases& grids = run_.own_truth();
  if (!deviation_of_grid_)
    deviation_of_grid_ =
        is_nested(grids[1].body)
            ? run_.result_of({.settings = grids[1],
                              .reference = grids[0],
                              .reference_grid = ReferenceGrid::converged})
                  .measures.deviation_l2_relative
            : std::nullopt;
  return *deviation_of_grid_;
}

}  // namespace springcheck
