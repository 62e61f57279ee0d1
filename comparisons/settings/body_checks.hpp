#pragma once

#include <functional>
#include <map>
#include <string>

#include "comparisons/cases/case.hpp"
#include "comparisons/settings/given.hpp"

namespace springcheck {

/// Settings by their keys, as they were given last.
using Settings = std::map<std::string, Given, std::less<>>;

/// nullptr where it is not given, or the key is empty. Throws std::logic_error for a
/// setting that is not declared.
const Given* find(const Settings& settings, std::string_view key);

/// Throws InputError for what does not go together: a body that the test does not cover,
/// cells that it cannot have. `file` is the scene's.
void check_body(const CaseSettings& common, const Settings& settings,
                const std::string& file);

}  // namespace springcheck
