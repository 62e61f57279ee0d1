#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "comparisons/settings/setting.hpp"

namespace springcheck {

/// JSON schema (draft 4, which editors of TOML know) of a setting's value in a file, and
/// what it is.
nlohmann::ordered_json schema_of(const Setting& setting);

/// Without what it is.
nlohmann::json schema_of_value(const Setting& setting);

/// An object of these properties and no others.
nlohmann::ordered_json schema_of_object(const nlohmann::ordered_json& properties);

/// An object of these properties and no others, none of which may be missing.
nlohmann::ordered_json whole_object(const nlohmann::ordered_json& properties);

/// A whole document: what it is, and which draft of JSON schema this is.
nlohmann::ordered_json schema_document(const std::string& title,
                                       const nlohmann::ordered_json& schema);

/// The JSON schema of scene files: an object of settings.
nlohmann::ordered_json scene_schema();

}  // namespace springcheck
