#include "comparisons/sweeps/sweep_schema.hpp"

#include <nlohmann/json.hpp>

#include "comparisons/settings/setting_schema.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

/// A value, or a list of them.
Json choices_schema(const std::string& description, const Json& value) {
  Json alternatives =
      Json::array({value, Json{{"type", "array"}, {"items", value}, {"minItems", 1}}});
  return {{"description", description}, {"anyOf", alternatives}};
}

/// {from, to, count}
Json range_schema(const Setting& setting) {
  const Json end = schema_of({.kind = setting.access.type.kind}, setting.dimension);
  const Json count{{"type", "integer"}, {"minimum", 2}, {"maximum", 1'000'000}};
  return whole_object({{"from", end}, {"to", end}, {"count", count}});
}

}  // namespace

Json sweep_schema() {
  Json definitions{{"scene", choices_schema("name of a shipped scene, or a .toml file",
                                            {{"type", "string"}})}};
  for (const Setting& setting : all_settings()) {
    if (!is_option(setting)) continue;
    const ValueType& type = setting.access.type;
    Json& choices = definitions[std::string(setting.key)] =
        choices_schema(help_of(setting), schema_of_value(setting));
    if (is_number(type)) choices["anyOf"].push_back(range_schema(setting));
  }
  Json properties;  // of the file and of each of its cases
  for (const auto& [name, definition] : definitions.items())
    properties[name] = {{"$ref", "#/definitions/" + name}};
  const Json one_case = schema_of_object(properties);
  properties["fields"] = {{"type", "boolean"},
                          {"description", "whether the result file keeps fields"}};
  properties["cases"] = {
      {"type", "array"},
      {"items", one_case},
      {"minItems", 1},
      {"description", "tables of options, each with the others of the file"}};
  Json schema = schema_of_object(properties);
  schema["definitions"] = definitions;
  return schema_document("A sweep of springcheck", schema);
}

}  // namespace springcheck
