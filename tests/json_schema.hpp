#pragma once

#include <toml++/toml.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

/// What of a value is against a JSON schema, a line for each; empty where nothing is.
inline std::string violations(const nlohmann::json& schema, const nlohmann::json& value) {
  using valijson::adapters::NlohmannJsonAdapter;
  valijson::Schema parsed;
  valijson::SchemaParser(valijson::SchemaParser::kDraft4)
      .populateSchema(NlohmannJsonAdapter(schema), parsed);
  valijson::ValidationResults results;
  valijson::Validator(valijson::Validator::kStrongTypes)
      .validate(parsed, NlohmannJsonAdapter(value), &results);
  std::string text;
  for (const valijson::ValidationResults::Error& error : results) {
    for (const std::string& part : error.context) text += part;
    text += ": " + error.description + "\n";
  }
  return text;
}

inline nlohmann::json json_of_toml(std::string_view text) {
  std::ostringstream json;
  json << toml::json_formatter(toml::parse(text));
  return nlohmann::json::parse(json.str());
}
