#pragma once

#include <algorithm>
#include <array>
#include <ranges>
#include <string_view>
#include <vector>

namespace springcheck {

/// A value of an enumeration by its name on the command line and in files.
template <class Value>
struct Named {
  Value value;
  std::string_view name;
  std::string_view description{};
};

/// The named values of an enumeration, in the order in which messages list them.
template <class Value>
inline constexpr std::array<Named<Value>, 0> value_names{};

template <class Value>
requires(!value_names<Value>.empty()) const auto& entry_of(Value value) {
  return *std::ranges::find_if(value_names<Value>,
                               [&](const auto& one) { return one.value == value; });
}

template <class Value>
auto all_values() {
  return value_names<Value> |
         std::views::transform([](const auto& one) { return one.value; });
}

template <class Value>
std::vector<std::string_view> names_of() {
  std::vector<std::string_view> names;
  for (const auto& one : value_names<Value>) names.push_back(one.name);
  return names;
}

/// The entry of that name; nullptr where there is none.
template <class Value>
const auto* find_value(std::string_view name) {
  const auto& all = value_names<Value>;
  const auto found =
      std::ranges::find_if(all, [&](const auto& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

template <class Value>
requires(!value_names<Value>.empty()) std::string_view name_of(Value value) {
  return entry_of(value).name;
}

}  // namespace springcheck
