#include "comparisons/chart/chart_models.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

std::vector<ChartModel> all_models() {
  using enum ChartKind;
  const Changes tetrahedra{{"cell-type", "tetrahedron"}}, prisms{{"cell-type", "prism"}};
  const Changes at_rest{{"solver", "static"}};
  std::vector<ChartModel> all;
  for (const char* springs : {"mss-baudet", "mss-nfd", "mss-fd", "mss-cf", "mss-affine"})
    all.push_back({springs, Changes{{"method", springs}} + at_rest, equilibrium});
  for (const char* springs : {"mss-affine", "mss-vangelder", "mss-lloyd"})
    all.push_back({fmt::format("{} on tetrahedra", springs),
                   Changes{{"method", springs}} + tetrahedra + at_rest, equilibrium});
  all.push_back({"mss-affine on prisms",
                 Changes{{"method", "mss-affine"}} + prisms + at_rest, equilibrium});
  for (const char* law : {"fem-hooke", "fem-stvk", "fem-hencky"})
    for (const char* element : {"q1", "q1-sri", "q2"})
      all.push_back({fmt::format("{}:{}", law, element),
                     {{"method", law}, {"element", element}},
                     equilibrium});
  const Changes mean_dilatation{{"method", "fem-stvk"}, {"element", "q1-sri"}};
  for (const char* solver : {"direct", "multigrid"})
    all.push_back({fmt::format("fem-stvk:q1-sri, {}", solver),
                   mean_dilatation + Changes{{"linear-solver", solver}}, equilibrium});
  all.push_back({"fem-cauchy-born:q1-sri",
                 {{"method", "fem-cauchy-born"}, {"element", "q1-sri"}},
                 equilibrium});
  all.push_back({"fem-stvk:q1 on tetrahedra",
                 Changes{{"method", "fem-stvk"}, {"element", "q1"}} + tetrahedra,
                 equilibrium});
  for (const char* method : {"mss-nfd", "mss-fd", "mss-cf", "mss-affine",
                             "fem-explicit-1p", "fem-explicit-8p"})
    for (const char* precision : {"double", "float"})
      all.push_back(
          {fmt::format("{}, {}", method, precision),
           {{"method", method}, {"solver", "semi-implicit"}, {"precision", precision}},
           motion});
  all.push_back(
      {"mss-affine on tetrahedra, double",
       Changes{{"method", "mss-affine"}, {"solver", "semi-implicit"}} + tetrahedra,
       motion});
  return all;
}

CaseSettings case_with(const std::string& scene, const std::vector<GivenSetting>& options,
                       const Changes& changes) {
  SceneFile file = read_scene(scene);
  std::erase_if(file.settings, [](const GivenSetting& setting) {
    return is_chosen_by_charts(setting.key);
  });
  file.settings.insert(file.settings.end(), options.begin(), options.end());
  for (const auto& [key, value] : changes) file.settings.push_back({key, value});
  return requests(make_run_settings(file.name, file.file, file.settings))
      .front()
      .settings;
}

Changes cells_of(const std::array<double, 3>& size, int across) {
  return {{"cells", cells_across(size, across)}};
}

/// A block's kinds of cells as a kidney has them; none of others.
std::optional<std::string> kidney_cells(const ChartModel& model) {
  for (const auto& [key, value] : model.changes)
    if (key == "cell-type")
      return value.text() == "tetrahedron" ? std::optional("free-tetrahedron")
                                           : std::nullopt;
  return "free-hexahedron";
}

std::vector<ChartModel> models_of_kidney() {
  std::vector<ChartModel> all;
  for (const ChartModel& model : all_models())
    if (const auto cells = kidney_cells(model))
      all.push_back({.name = model.name,
                     .changes = model.changes + Changes{{"cell-type", *cells}},
                     .kind = model.kind});
  return all;
}

}  // namespace

bool is_chosen_by_charts(std::string_view key) {
  const Setting* setting = find_setting(key);
  return setting != nullptr && setting->in_charts == InCharts::chosen;
}

std::vector<GivenSetting> options_for(ChartKind kind, std::vector<GivenSetting> options) {
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

const ChartModel& model_named(const std::string& name, ChartKind kind, BodyShape shape) {
  for (const ChartModel& model : chart_models(shape))
    if (model.name == name && model.kind == kind) return model;
  throw std::logic_error("no model '" + name + "'");
}

Body chart_body(const std::string& scene, const std::vector<GivenSetting>& options) {
  const Body body =
      read_run(scene, options_for(ChartKind::equilibrium, options)).common.body;
  if (body.shape != BodyShape::block && body.shape != BodyShape::kidney)
    throw InputError(scene, "body", "a block or a kidney, to be cut as finely as wanted",
                     "a " + std::string(name_of(body.shape)));
  return body;
}

const std::vector<std::string>& truth_laws() {
  static const std::vector<std::string> all{"fem-hooke", "fem-stvk", "fem-hencky",
                                            "fem-cauchy-born"};
  return all;
}

Cells cells_across(const std::array<double, 3>& size, int across) {
  const double edge = std::ranges::min(size) / across;
  Cells cells{};
  std::ranges::transform(size, cells.begin(), [&](double length) {
    return static_cast<int>(std::lround(length / edge));
  });
  return cells;
}

CaseSettings model_case(const std::string& scene,
                        const std::vector<GivenSetting>& options, const ChartModel& model,
                        int across) {
  const std::vector<GivenSetting> own = options_for(model.kind, options);
  return case_with(scene, own,
                   cells_of(chart_body(scene, own).block.size, across) + model.changes);
}

ThreeCases truth_grids(const std::string& scene, const std::vector<GivenSetting>& options,
                       const std::string& law, const std::optional<int>& across) {
  constexpr double most_nodes = 1e5;
  const std::vector<GivenSetting> own = options_for(ChartKind::equilibrium, options);
  const Body body = chart_body(scene, own);
  const Changes elements{{"method", law}, {"element", "q2"}};
  if (body.shape == BodyShape::kidney) {
    const int coarsest = across.value_or(4);
    if (coarsest < 2)
      throw InputError("--truth", "",
                       "at least 2 cells across a body whose meshes are not nested",
                       std::to_string(coarsest));
    const auto grid = [&](int cells_across) {
      return case_with(
          scene, own,
          cells_of(body.block.size, cells_across) + elements +
              Changes{{"cell-type", "free-hexahedron"}, {"linear-solver", "direct"}});
    };
    return {grid(coarsest), grid(coarsest * 3 / 2), grid(2 * coarsest)};
  }
  double finest_nodes = 1;
  for (const int cells : cells_across(body.block.size, 16)) finest_nodes *= 2 * cells + 1;
  const bool is_beam = finest_nodes > most_nodes;
  Changes changes = cells_of(body.block.size, across.value_or(is_beam ? 2 : 4)) +
                    elements + Changes{{"cell-type", "hexahedron"}, {"distortion", 0}};
  if (is_beam) changes.emplace_back("linear-solver", "direct");
  return convergence_grids(case_with(scene, own, changes));
}

}  // namespace springcheck
