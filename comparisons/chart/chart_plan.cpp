#include "comparisons/chart/chart_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/cases/mechanical_scene.hpp"
#include "comparisons/chart/chart_models.hpp"
#include "comparisons/measures/displacement_norms.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/running/memory.hpp"
#include "comparisons/settings/case_json.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/studies/converged.hpp"
#include "comparisons/studies/formal_order.hpp"
#include "comparisons/system/environment.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/sha256.hpp"

namespace springcheck {
namespace {

/// The measure that answers a test's load; a plate's force along its motion, in shearing
/// too.
std::string answer_of(Test test, const std::string& scene) {
  const TestName& entry = entry_of(test);
  if (entry.deforms && !entry.turns) return "plate_force";
  if (entry.deforms || test == Test::bending) return std::string(entry.answer);
  throw InputError(scene, "test", "one that a plate or a weight answers",
                   std::string(entry.name));
}

RunSettings scene_of(const ChartPlan& plan) {
  return read_run(plan.scene, options_for(ChartKind::equilibrium, plan.options));
}

/// The plan's, or that which `run` measures deviations from, by default or as the scene
/// says; St-Venant-Kirchhoff's where that is none.
std::string law_of(const ChartPlan& plan) {
  if (!plan.law.empty()) return plan.law;
  const Request first = requests(scene_of(plan)).front();
  const std::string& name =
      (first.reference ? *first.reference : first.settings).method.name;
  return is_law(name) ? name : usual_law(false).name;
}

/// Times of one chart are of one environment and of one program.
std::string measured_on() {
  return fmt::format("{}, revision {}", text_of(environment()), build_info::revision);
}

/// What determines all models of the chart, whichever they are.
std::string hash_of_models(const ChartPlan& plan) {
  std::string all;
  for (const ChartModel& model : chart_models(chart_body(plan.scene, plan.options).shape))
    all += settings_json(model_case(plan.scene, plan.options, model, 2)).dump();
  return sha256(all);
}

StoredChart::Grids stored_grids(const ThreeCases& cases, MeshStore& meshes) {
  StoredChart::Grids grids{.cell_sizes = grid_sizes(cases),
                           .formal_order = formal_order(cases.front())};
  std::ranges::transform(cases, grids.keys.begin(), [&](const CaseSettings& grid) {
    return case_key({.settings = grid}, meshes.mesh(grid.body));
  });
  return grids;
}

}  // namespace

ChartPlan quick_plan(const std::string& scene, int threads, int jobs) {
  return {.scene = scene,
          .options = {},
          .models = ChartModels::foremost,
          .across = {4, 6, 10},
          .threads = {threads},
          .budget = 2,
          .repeat_for = 0.2,
          .jobs = jobs,
          .retime = false,
          .least_models = 0};
}

CaseSettings settings_of(const ChartPlan& plan, const StoredChart::Point& point) {
  const BodyShape shape = chart_body(plan.scene, plan.options).shape;
  return model_case(plan.scene, plan.options, chart_model(point.model, shape),
                    point.across);
}

void check_plan(const ChartPlan& plan) {
  planned_truths(plan);
  for (const ChartModel& model :
       chosen_models(plan.models, chart_body(plan.scene, plan.options).shape))
    for (const int across : plan.across)
      check_mesh_memory(plan.scene,
                        model_case(plan.scene, plan.options, model, across).body);
}

std::vector<TruthGrids> planned_truths(const ChartPlan& plan) {
  std::vector<std::string> laws{law_of(plan)};
  for (const std::string& law : plan.laws)
    if (law != laws.front()) laws.push_back(law);
  std::vector<TruthGrids> truths;
  for (const std::string& law : laws)
    truths.push_back(truth_grids(plan.scene, plan.options, law, plan.truth_across));
  return truths;
}

std::string caution_of_truth(const ChartPlan& plan) {
  return caution_near_half(*find_method(law_of(plan)), scene_of(plan).common);
}

StoredChart planned_chart(const ChartPlan& plan, const std::vector<TruthGrids>& truths,
                          MeshStore& meshes) {
  const CaseSettings common = scene_of(plan).common;
  const CaseSettings& first = truths.front().grids.front();
  const Mesh& mesh = meshes.mesh(first.body);
  StoredChart chart{.scene = common.scene,
                    .settings = hash_of_models(plan),
                    .law = first.method.name,
                    .answer = answer_of(common.test, plan.scene),
                    .height = first.body.block.size[2],
                    .machine = measured_on(),
                    .revision = build_info::revision};
  if (first.test != Test::bending)
    chart.imposed = largest_imposed_displacement(mesh, mechanical_scene(first, mesh));
  for (const TruthGrids& truth : truths)
    chart.truths.push_back({.law = truth.grids.front().method.name,
                            .grids = stored_grids(truth.grids, meshes),
                            .check = stored_grids(truth.check, meshes)});
  return chart;
}

}  // namespace springcheck
