#include <nlohmann/json.hpp>

#include "comparisons/gates/gate_keys.hpp"
#include "comparisons/gates/gate_output.hpp"
#include "comparisons/settings/setting_schema.hpp"

namespace springcheck::gates {
namespace {

using Json = nlohmann::ordered_json;

/// A table of columns, each with its value, or the values of which it has one.
Json conditions_schema() {
  const Json value{{"type", {"number", "string", "boolean"}}};
  const Json values{
      {"type", "array"},
      {"minItems", 1},
      {"items", {{"anyOf", {value, {{"type", "array"}, {"items", value}}}}}}};
  return {{"type", "object"}, {"additionalProperties", {{"anyOf", {value, values}}}}};
}

}  // namespace

Json gate_schema() {
  Json properties;
  for (const GateKey& key : gate_keys()) {
    Json& property =
        properties[std::string(key.name)] = {{"description", key.description}};
    property.update(key.type.kind == ValueType::Kind::table ? conditions_schema()
                                                            : Json(schema_of(key.type)));
  }
  Json gate = schema_of_object(properties);
  gate["required"] = {"name", "reason"};
  Json file =
      schema_of_object({{"where", properties["where"]},
                        {"fixed", properties["fixed"]},
                        {"gate", {{"type", "array"}, {"minItems", 1}, {"items", gate}}}});
  file["required"] = {"gate"};
  return schema_document("Gates of springcheck", file);
}

Json report_schema() {
  const Json text{{"type", "string"}}, count{{"type", "integer"}},
      value{{"type", "number"}}, number_or_null{{"type", {"number", "null"}}},
      texts{{"type", "array"}, {"items", text}};
  const auto list_of = [](const Json& properties) {
    return Json{{"type", "array"}, {"items", whole_object(properties)}};
  };
  const Json verdict = schema_of(type_of<Judgement>());
  return whole_object(
      {{"springcheck", text},
       {"gates", text},
       {"results", text},
       {"pass", count},
       {"fall_short", count},
       {"no_case", count},
       {"margin", text},
       {"blessed", list_of({{"name", text}, {"old", value}, {"new", value}})},
       {"other_revisions", {{"type", "object"}, {"additionalProperties", count}}},
       {"accepts_other_revisions", {{"type", "boolean"}}},
       {"verdicts", list_of({{"name", text},
                             {"verdict", verdict},
                             {"measure", text},
                             {"got", number_or_null},
                             {"values", {{"type", "array"}, {"items", value}}},
                             {"band", whole_object({{"low", number_or_null},
                                                    {"high", number_or_null},
                                                    {"text", text}})},
                             {"margin", number_or_null},
                             {"explanation", text},
                             {"reason", text},
                             {"where", text},
                             {"keys", texts},
                             {"place", text}})}});
}

}  // namespace springcheck::gates
