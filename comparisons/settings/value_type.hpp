#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "comparisons/settings/named_values.hpp"
#include "comparisons/settings/units.hpp"

namespace springcheck {

/// What may stand under a key of a file, or be given to an option.
struct ValueType {
  enum class Kind { truth, integer, number, text, table };

  static constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

  Kind kind;                        // its name is that of JSON schemas
  std::size_t least = 1, most = 1;  // how many values; a single one needs no list
  // For text the names that there are; for numbers the names that are understood in their
  // place. nullptr: any text, or no names.
  std::vector<std::string_view> (*names)() = nullptr;
};

template <>
inline constexpr std::array value_names<ValueType::Kind>{
    Named{ValueType::Kind::truth, "boolean"}, Named{ValueType::Kind::integer, "integer"},
    Named{ValueType::Kind::number, "number"}, Named{ValueType::Kind::text, "string"},
    Named{ValueType::Kind::table, "object"}};

inline bool holds_numbers(const ValueType& type) {
  return type.kind == ValueType::Kind::number || type.kind == ValueType::Kind::integer;
}
inline bool is_number(const ValueType& type) {
  return holds_numbers(type) && type.most == 1;
}
inline bool is_list_of_numbers(const ValueType& type) {
  return holds_numbers(type) && type.most > 1;
}

inline std::vector<std::string_view> automatic() {
  return {"auto"};
}

/// What a reader takes that returns a value of this type: a number, one of the names of
/// an enumeration, or as many of them as an array has.
template <class Value>
constexpr ValueType type_of() {
  using enum ValueType::Kind;
  const auto times = [](ValueType type, std::size_t least, std::size_t most) {
    type.least = least;
    type.most = most;
    return type;
  };
  if constexpr (std::is_same_v<Value, bool>)
    return {truth};
  else if constexpr (std::is_integral_v<Value>)
    return {integer};
  else if constexpr (std::is_floating_point_v<Value>)
    return {number};
  else if constexpr (std::is_same_v<Value, std::string>)
    return {text};
  else if constexpr (requires { Value::SizeAtCompileTime; })  // vector, matrix
    return times({number}, Value::SizeAtCompileTime, Value::SizeAtCompileTime);
  else if constexpr (requires { std::tuple_size<Value>::value; })  // array
    return times(type_of<typename Value::value_type>(), std::tuple_size_v<Value>,
                 std::tuple_size_v<Value>);
  else if constexpr (requires(Value value) { value.push_back(value.front()); })
    return times(type_of<typename Value::value_type>(), 1, ValueType::any_number);
  else if constexpr (requires { typename Value::value_type; }) {  // optional
    ValueType type = type_of<typename Value::value_type>();
    if (type.kind != text) type.names = automatic;
    return type;
  } else
    return {.kind = text, .names = all_names<Value>};
}

/// The JSON schema of the type, in which numbers may carry a unit of the dimension.
nlohmann::json schema_of(const ValueType& type, Dimension dimension = Dimension::none);

}  // namespace springcheck
