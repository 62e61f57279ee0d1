#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/cases/request.hpp"
#include "comparisons/cases/status.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/settings/given.hpp"

namespace springcheck {

/// The values that users give by name, and their names: {value, name} of enumerations, or
/// values that hold their name.
template <class Value>
decltype(auto) named_values() {
  if constexpr (std::is_same_v<Value, Method>)
    return methods();
  else if constexpr (std::is_same_v<Value, ElementName>)
    return elements();
  else if constexpr (std::is_same_v<Value, LatticeName>)
    return lattices();
  else if constexpr (std::is_same_v<Value, MeshUnit>)
    return mesh_units();
  else if constexpr (std::is_same_v<Value, tissue::Organ>)
    return tissue::organs();
  else if constexpr (std::is_same_v<Value, CellPattern>)
    return cell_patterns();
  else if constexpr (std::is_same_v<Value, BodyShape>)
    return std::span(value_names<BodyShape>).template first<3>();  // a file has no name
  else
    return (value_names<Value>);
}

template <class Value>
std::vector<std::string_view> all_names() {
  std::vector<std::string_view> names;
  for (const auto& entry : named_values<Value>()) names.emplace_back(entry.name);
  return names;
}

/// The value of this name, which stands in what was given. Throws InputError without one.
template <class Value>
Value value_named(const Given& given, std::string_view name) {
  for (const auto& entry : named_values<Value>())
    if (entry.name == name) {
      if constexpr (requires { entry.value; })
        return entry.value;
      else
        return entry;
    }
  given.refuse_name(name, all_names<Value>());
}

/// The value that was given.
template <class Value>
Value named(const Given& given) {
  return value_named<Value>(given, given.text());
}

}  // namespace springcheck
