#include "comparisons/settings/setting_schema.hpp"

#include <nlohmann/json.hpp>

#include "comparisons/settings/cut_keys.hpp"

namespace springcheck {

using Json = nlohmann::ordered_json;

// The only setting of tables is that of cuts.
nlohmann::json schema_of_value(const Setting& setting) {
  if (setting.access.type.kind == ValueType::Kind::table) return cuts_schema();
  return schema_of(setting.access.type, setting.dimension);
}

Json schema_of(const Setting& setting) {
  Json schema{{"description", help_of(setting)}};
  schema.update(schema_of_value(setting));
  return schema;
}

Json schema_of_object(const Json& properties) {
  return {
      {"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
}

Json whole_object(const Json& properties) {
  Json schema = schema_of_object(properties);
  for (const auto& [name, property] : properties.items())
    schema["required"].push_back(name);
  return schema;
}

Json schema_document(const std::string& title, const Json& schema) {
  Json document{{"$schema", "http://json-schema.org/draft-04/schema#"}, {"title", title}};
  document.update(schema);
  return document;
}

Json scene_schema() {
  Json properties;
  for (const Setting& setting : all_settings())
    properties[std::string(setting.key)] = schema_of(setting);
  Json schema = schema_of_object(properties);
  schema["required"] = {"test"};  // which is no option
  return schema_document("A scene of springcheck", schema);
}

}  // namespace springcheck
