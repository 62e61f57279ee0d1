#pragma once

#include <functional>
#include <map>
#include <string>

#include "comparisons/cases/case.hpp"
#include "comparisons/settings/given.hpp"

namespace springcheck {

/// Settings by their keys, as they were given last.
using Settings = std::map<std::string, Given, std::less<>>;

/// The setting; throws InputError where it is missing. `file` is the scene's.
const Given& required(const Settings& settings, const std::string& key,
                      const std::string& file, const std::string& expected);

template <class Value, class Read>
Value value_or(const Settings& settings, std::string_view key, Value otherwise,
               Read&& read) {
  const auto found = settings.find(key);
  return found == settings.end() ? otherwise : Value(std::invoke(read, found->second));
}

/// What is deformed, and its mesh. A mesh given by an option stands in place of the
/// scene's own body. Throws InputError for what does not go together: a mesh beside cell
/// counts of the same place, plates' names without a mesh, a body that the test does not
/// cover.
Body body_of(const Settings& settings, const std::string& file, Test test);

}  // namespace springcheck
