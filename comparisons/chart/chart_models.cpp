#include "comparisons/chart/chart_models.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

ChartKind kind_of(const Model& model) {
  return model.precision ? ChartKind::motion : ChartKind::equilibrium;
}

/// The settings that the model changes, as a scene would give them.
GivenSettings changes_of(const Model& model, const Method& method) {
  GivenSettings changes{{"method", model.method}};
  if (!model.element.empty()) changes.push_back({"element", model.element});
  if (model.cells != CellType::hexahedron)
    changes.push_back({"cell-type", std::string(name_of(model.cells))});
  if (!model.linear_solver.empty())
    changes.push_back({"linear-solver", model.linear_solver});
  if (method.follows_solver)
    changes.push_back({"solver", model.precision ? "semi-implicit" : "static"});
  if (model.precision)
    changes.push_back({"precision", std::string(name_of(*model.precision))});
  return changes;
}

/// All models: equilibria by springs, then by finite elements, then motions; hexahedra
/// come first.
std::vector<ChartModel> all_models() {
  std::vector<ChartModel> all;
  for (const Method& method : methods())
    for (Model model : method.charted) {
      model.method = method.name;
      all.push_back({model, changes_of(model, method), kind_of(model)});
    }
  constexpr std::array cells{CellType::hexahedron, CellType::tetrahedron,
                             CellType::pyramid, CellType::prism};
  std::ranges::stable_sort(all, {}, [&](const ChartModel& one) {
    const bool is_at_rest = one.kind == ChartKind::equilibrium;
    const Family family = find_method(one.model.method)->family;
    return std::tuple(one.kind, is_at_rest ? family : Family::springs,
                      std::ranges::find(cells, one.model.cells) - cells.begin());
  });
  return all;
}

/// The scene's case with the changes, without what the scene says of settings that charts
/// choose.
CaseSettings case_with(const std::string& scene, const GivenSettings& changes) {
  SceneFile file = read_scene(scene);
  std::erase_if(file.settings, [](const GivenSetting& setting) {
    return is_chosen_by_charts(setting.key);
  });
  return case_of_scene(file, changes);
}

GivenSettings cells_of(const std::array<double, 3>& size, int across) {
  return {{"cells", cells_across(size, across)}};
}

/// A kidney's kind of cells for a block's kind; none for others.
std::optional<std::string> kidney_cells(CellType cells) {
  if (cells == CellType::tetrahedron) return "free-tetrahedron";
  if (cells == CellType::hexahedron) return "free-hexahedron";
  return std::nullopt;
}

std::vector<ChartModel> models_of_kidney() {
  std::vector<ChartModel> all = all_models();
  std::erase_if(all, [](ChartModel& one) {
    const auto cells = kidney_cells(one.model.cells);
    if (cells) one.changes = one.changes + GivenSettings{{"cell-type", *cells}};
    return !cells;
  });
  return all;
}

}  // namespace

bool is_chosen_by_charts(std::string_view key) {
  const Setting* setting = find_setting(key);
  return setting != nullptr && setting->in_charts == InCharts::chosen;
}

GivenSettings options_for(ChartKind kind, GivenSettings options) {
  if (kind == ChartKind::equilibrium)
    std::erase_if(options, [](const GivenSetting& option) {
      return find_setting(option.key)->readers.unread == Unread::refused_as_option;
    });
  return options;
}

const std::vector<ChartModel>& chart_models(BodyShape shape) {
  static const std::vector<ChartModel> block = all_models(), kidney = models_of_kidney();
  return shape == BodyShape::kidney ? kidney : block;
}

bool is_foremost(const Model& model) {
  const Method* method = find_method(model.method);
  return method != nullptr && method->foremost > 0 &&
         model.cells == CellType::hexahedron && model.linear_solver.empty();
}

std::vector<ChartModel> chosen_models(ChartModels which, BodyShape shape) {
  std::vector<ChartModel> chosen = chart_models(shape);
  if (which == ChartModels::foremost)
    std::erase_if(chosen, [](const ChartModel& one) { return !is_foremost(one.model); });
  return chosen;
}

const ChartModel& chart_model(const Model& model, BodyShape shape) {
  const auto& all = chart_models(shape);
  const auto found = std::ranges::find(all, model, &ChartModel::model);
  if (found == all.end()) throw std::logic_error("no model '" + name_of(model) + "'");
  return *found;
}

Body chart_body(const std::string& scene, const GivenSettings& options) {
  const Body body =
      read_run(scene, options_for(ChartKind::equilibrium, options)).common.body;
  if (body.shape != BodyShape::block && body.shape != BodyShape::kidney)
    throw InputError(scene, "body", "a block or a kidney, to be cut as finely as wanted",
                     "a " + std::string(name_of(body.shape)));
  return body;
}

bool is_nested(const Body& body) {
  return body.shape == BodyShape::block;
}

const std::vector<std::string>& truth_laws() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names;
    for (const Method* law : laws()) names.push_back(law->name);
    return names;
  }();
  return all;
}

std::string truth_law_named(const std::string& name) {
  if (!name.empty() && std::ranges::count(truth_laws(), name) == 0)
    Given::from_text("--converged-law", name)
        .refuse_name(name, {truth_laws().begin(), truth_laws().end()});
  return name;
}

Cells cells_across(const std::array<double, 3>& size, int across) {
  const double edge = std::ranges::min(size) / across;
  Cells cells{};
  std::ranges::transform(size, cells.begin(), [&](double length) {
    return static_cast<int>(std::lround(length / edge));
  });
  return cells;
}

CaseSettings model_case(const std::string& scene, const GivenSettings& options,
                        const ChartModel& model, int across) {
  const GivenSettings own = options_for(model.kind, options);
  return case_with(
      scene, own + cells_of(chart_body(scene, own).block.size, across) + model.changes);
}

namespace {

ThreeCases q2_grids(const std::string& scene, const GivenSettings& options,
                    const std::string& law, const std::optional<int>& across) {
  constexpr double most_nodes = 1e5;
  const GivenSettings own = options_for(ChartKind::equilibrium, options);
  const Body body = chart_body(scene, own);
  const GivenSettings elements{{"method", law}, {"element", std::string(truth_element)}};
  if (body.shape == BodyShape::kidney) {
    const int coarsest = across.value_or(4);
    if (coarsest < 2)
      throw InputError("--converged-across", "",
                       "at least 2 cells across a body whose meshes are not nested",
                       std::to_string(coarsest));
    const auto grid = [&](int cells_across) {
      return case_with(scene, own + cells_of(body.block.size, cells_across) + elements +
                                  GivenSettings{{"cell-type", "free-hexahedron"},
                                                {"linear-solver", "direct"}});
    };
    return {grid(coarsest), grid(coarsest * 3 / 2), grid(2 * coarsest)};
  }
  double finest_nodes = 1;
  for (const int cells : cells_across(body.block.size, 16)) finest_nodes *= 2 * cells + 1;
  const bool is_beam = finest_nodes > most_nodes;
  GivenSettings changes = cells_of(body.block.size, across.value_or(is_beam ? 2 : 4)) +
                          elements +
                          GivenSettings{{"cell-type", "hexahedron"}, {"distortion", 0}};
  if (is_beam) changes.push_back({"linear-solver", "direct"});
  return convergence_grids(case_with(scene, own + changes));
}

}  // namespace

TruthGrids truth_grids(const std::string& scene, const GivenSettings& options,
                       const std::string& law, const std::optional<int>& across) {
  const ThreeCases grids = q2_grids(scene, options, law, across);
  ThreeCases check = grids;
  for (CaseSettings& grid : check) {
    grid.elements.element = *find_element(check_element);
    grid.body.block.cells = refined(grid.body.block.cells, 2);
  }
  return {grids, check};
}

}  // namespace springcheck
