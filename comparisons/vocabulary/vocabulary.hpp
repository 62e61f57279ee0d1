#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace springcheck {

/// What there is by name, in lists of the names that list_names has: methods, scenes,
/// measures and so on, as documents of {list: {name: text or {"description": text,
/// ...}}}. An empty `what` is everything, and nothing is there of a list that there is
/// not.
nlohmann::ordered_json list_json(const std::string& what);

/// Its JSON schema.
nlohmann::ordered_json list_schema();

std::vector<std::string_view> list_names();

/// What a list has; nothing of a list that there is not.
std::vector<std::string> names_in_list(const std::string& list);

}  // namespace springcheck
