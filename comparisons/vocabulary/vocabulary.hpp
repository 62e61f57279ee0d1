#pragma once

#include <nlohmann/json_fwd.hpp>

namespace springcheck {

/// What there is by name: methods, scenes, measures and so on, as a document of {list:
/// {name: text or {"description": text, ...}}}.
nlohmann::ordered_json list_json();

/// The JSON schema of list_json().
nlohmann::ordered_json list_schema();

}  // namespace springcheck
