#include "comparisons/commands/result_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/settings/case_json.hpp"
#include "comparisons/tables/studies/split_output.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

Json json(const Measures::Value& value) {
  return value ? Json(*value) : Json();
}
Json json(const Measures::Vector& value) {
  return value ? Json{value->x(), value->y(), value->z()} : Json();
}
Json json(const Measures::Matrix& value) {
  if (!value) return {};
  Json rows = Json::array();
  for (const auto& row : value->rowwise()) rows.push_back({row[0], row[1], row[2]});
  return rows;
}

Json types_json(const Mesh& mesh) {
  Json types = Json::object();
  for (const CellType type : all_cell_types)
    if (const std::size_t count = mesh.count(type); count > 0)
      types[std::string(name_of(type))] = count;
  return types;
}

/// A list of numbers for each column; null without samples.
Json history_json(const History& history) {
  if (history.empty()) return {};
  Json columns = Json::object();
  for (std::size_t i = 0; i < history_columns.size(); ++i) {
    Json& column = columns[std::string(history_columns[i])] = Json::array();
    for (const HistorySample& sample : history)
      column.push_back(std::isfinite(sample[i]) ? Json(sample[i]) : Json());
  }
  return columns;
}

Json case_json(const CaseResult& result, const Mesh& mesh) {
  const CaseSettings& settings = result.request.settings;
  const bool fem = is_finite_element(settings.method);
  Json flags = Json::array();
  for (const Status flag : result.flags) flags.push_back(name_of(flag));
  Json out{{"method", settings.method.name},
           {"element", fem ? Json(settings.elements.element.name) : Json()},
           {"source", settings_json(settings).value("source", Json())},
           {"solver", settings_json(settings).value("solver", Json())},
           {"nu", settings.material.poisson_ratio},
           {"young", settings_json(settings).value("young", Json())},
           {"density", settings.material.density},
           {"deformation", json(settings.deformation)},
           {"traction", settings.test == Test::traction
                            ? json(Measures::Vector(settings.traction))
                            : Json()},
           {"gradient", settings.test == Test::affine
                            ? json(Measures::Matrix(settings.gradient))
                            : Json()},
           {"stiffness", settings_json(settings).value("stiffness", Json())},
           {"kappa", settings_json(settings).value("kappa", Json())},
           {"law", settings_json(settings).value("law", Json())},
           {"mesh",
            {{"cells", mesh.cells().size()},
             {"nodes", mesh.nodes().size()},
             {"types", types_json(mesh)},
             {"sha256", mesh.sha256()}}},
           {"status", name_of(result.status)},
           {"flags", flags},
           {"reason", result.reason.empty() ? Json() : Json(result.reason)}};
  for_each_measure(result.measures,
                   [&](const char* name, const auto& value) { out[name] = json(value); });
  const Solution& solution = result.solution;
  out["reference"] =
      result.request.reference ? Json(reference_label(result.request)) : Json();
  const bool is_ours = !is_measured(settings.method);
  const bool ran = is_ours && result.status != Status::refused;
  out["load_fraction"] = ran ? Json(solution.load_fraction) : Json();
  out["steps"] = ran ? Json(solution.steps) : Json();
  out["linear_iterations"] =
      solution.linear_iterations ? Json(*solution.linear_iterations) : Json();
  out["factorisations"] =
      solution.factorisations ? Json(*solution.factorisations) : Json();
  out["dt"] = json(solution.dt);
  out["dt_limit"] = json(solution.dt_limit);
  out["history"] = history_json(result.history);
  out["force_evaluations"] = ran ? Json(solution.force_evaluations) : Json();
  out["wall_s"] = is_ours ? Json(result.wall_s) : Json();
  out["solve_wall_s"] = is_ours ? Json(result.solve_wall_s) : Json();
  out["key"] = result.key;
  return out;
}

}  // namespace

Json run_json(const std::string& scene, const std::vector<CaseResult>& results,
              const std::vector<std::optional<Split>>& splits, MeshStore& meshes) {
  Json cases = Json::array();
  for (std::size_t i = 0; i < results.size(); ++i) {
    Json out = case_json(results[i], meshes.mesh(results[i].request.settings.body));
    out["split"] = splits[i] ? split_json(*splits[i]) : Json();
    cases.push_back(std::move(out));
  }
  return {{"springcheck", build_info::version}, {"scene", scene}, {"results", cases}};
}

}  // namespace springcheck
