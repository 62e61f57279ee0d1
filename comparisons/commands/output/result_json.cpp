#include "comparisons/commands/output/result_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/settings/case_json.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/settings/setting_schema.hpp"
#include "comparisons/tables/studies/split_output.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

// Values of a case as JSON:

template <class Value>
Json json(const Value& value) {
  return value;
}
Json json(Status status) {
  return name_of(status);
}
Json json(const Vector3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}
Json json(const Eigen::Matrix3d& matrix) {
  Json rows = Json::array();
  for (const auto& row : matrix.rowwise()) rows.push_back({row[0], row[1], row[2]});
  return rows;
}
Json json(const std::vector<Status>& statuses) {
  Json names = Json::array();
  for (const Status status : statuses) names.push_back(name_of(status));
  return names;
}
Json json(const Mesh& mesh) {
  Json types = Json::object();
  for (const CellType type : all_cell_types)
    if (const std::size_t count = mesh.count(type); count > 0)
      types[std::string(name_of(type))] = count;
  return {{"cells", mesh.cells().size()},
          {"nodes", mesh.nodes().size()},
          {"types", types},
          {"sha256", mesh.sha256()}};
}
/// A history as a list of numbers for each column.
Json json(const History& history) {
  Json columns = Json::object();
  for (std::size_t i = 0; i < history_columns.size(); ++i) {
    Json& column = columns[std::string(history_columns[i])] = Json::array();
    for (const HistorySample& sample : history)
      column.push_back(std::isfinite(sample[i]) ? Json(sample[i]) : Json());
  }
  return columns;
}
template <class Value>
Json json(const std::optional<Value>& value) {
  return value ? json(*value) : Json();
}

// JSON schemas of the values of a case:

template <class Value>
Json schema(const Value&) {
  return schema_of(type_of<Value>());
}
Json schema(const Eigen::Matrix3d&) {
  return {
      {"type", "array"}, {"items", schema(Vector3())}, {"minItems", 3}, {"maxItems", 3}};
}
Json schema(const std::vector<Status>&) {
  return {{"type", "array"}, {"items", schema(Status{})}};
}
Json schema(const Mesh&) {
  const Json count = schema(1);
  Json types;
  for (const CellType type : all_cell_types) types[std::string(name_of(type))] = count;
  return schema_of_object({{"cells", count},
                           {"nodes", count},
                           {"types", schema_of_object(types)},
                           {"sha256", schema(std::string())}});
}
Json schema(const History&) {
  Json columns;
  for (const std::string_view column : history_columns)
    columns[std::string(column)] = {{"type", "array"},
                                    {"items", {{"type", {"number", "null"}}}}};
  return schema_of_object(columns);
}
template <class Value>
Json schema(const std::optional<Value>&) {
  return {{"anyOf", {schema(Value{}), {{"type", "null"}}}}};
}

template <class Value>
std::optional<Value> where(bool is_there, const Value& value) {
  return is_there ? std::optional(value) : std::nullopt;
}

/// Calls visit(name, value) with all that JSON tells of a case, in its order.
template <class Visit>
void for_each_told(const CaseResult& result, const Mesh& mesh, const Visit& visit) {
  const CaseSettings& settings = result.request.settings;
  const nlohmann::json told = settings_json(settings);
  const auto visit_setting = [&]<class Value>(std::string_view name,
                                              std::optional<Value>) {
    visit(name, told.contains(name) ? std::optional(told[name].get<Value>())
                                    : std::optional<Value>());
  };
  constexpr std::optional<std::string> text;
  constexpr std::optional<double> number;
  constexpr std::optional<std::array<double, 3>> three_numbers;
  for (const char* name : {"method", "element", "source", "solver"})
    visit_setting(name, text);
  visit("variant", variant_label(settings));
  for (const char* name : {"nu", "young", "density", "deformation"})
    visit_setting(name, number);
  visit_setting("traction", three_numbers);
  visit("gradient", where(settings.test == Test::affine, settings.gradient));
  visit_setting("stiffness", three_numbers);
  visit_setting("kappa", number);
  visit_setting("law", text);
  visit("mesh", mesh);
  visit("status", result.status);
  visit("flags", result.flags);
  visit("reason", where(!result.reason.empty(), result.reason));
  const auto visit_measures = [&](bool are_times) {
    for_each_measure(result.measures, [&](const Measure& measure, const auto& value) {
      if (measure.traits.is_time == are_times) visit(measure.name, value);
    });
  };
  visit_measures(false);
  const Solution& solution = result.solution;
  const auto& reference = result.request.reference;
  visit("reference",
        where(reference.has_value(), reference ? reference_label(result.request) : ""));
  const bool is_ours = settings.method.solve != nullptr;
  const bool ran =
      is_ours && result.status != Status::refused && result.status != Status::error;
  visit("load_fraction", where(ran, solution.load_fraction));
  visit("steps", where(ran, solution.steps));
  visit("linear_iterations", solution.linear_iterations);
  visit("factorisations", solution.factorisations);
  visit("dt", solution.dt);
  visit("dt_limit", solution.dt_limit);
  visit("history", where(!result.history.empty(), result.history));
  visit("force_evaluations", where(ran, solution.force_evaluations));
  visit_measures(true);
  visit("key", result.key);
  visit("revision",
        result.revision.empty() ? std::string(build_info::revision) : result.revision);
}

}  // namespace

Json run_json(const std::string& scene, const std::vector<CaseResult>& results,
              const std::vector<std::optional<Split>>& splits, MeshStore& meshes) {
  Json cases = Json::array();
  for (std::size_t i = 0; i < results.size(); ++i) {
    Json out;
    for_each_told(results[i], meshes.mesh(results[i].request.settings.body),
                  [&](std::string_view name, const auto& value) {
                    out[std::string(name)] = json(value);
                  });
    out["split"] = splits[i] ? split_json(*splits[i]) : Json();
    cases.push_back(std::move(out));
  }
  return {{"springcheck", build_info::version}, {"scene", scene}, {"results", cases}};
}

Json run_schema() {
  // The schema is made from any case: all tell the same keys.
  const CaseSettings settings =
      case_of_scene("compression", {{"method", "mss-cf"}, {"cells", Cells{1, 1, 1}}});
  const CaseResult result{.request = {.settings = settings}, .status = Status::ok};
  Json properties;
  for_each_told(result, build_mesh(settings.body),
                [&](std::string_view name, const auto& value) {
                  properties[std::string(name)] = schema(value);
                });
  properties["split"] = {{"type", {"object", "null"}}};
  const Json text{{"type", "string"}};
  return whole_object(
      {{"springcheck", text},
       {"scene", text},
       {"results", {{"type", "array"}, {"items", whole_object(properties)}}}});
}

}  // namespace springcheck
