#include "comparisons/settings/value_type.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

namespace springcheck {
namespace {

/// "5kPa": a number with one of the units behind it.
nlohmann::json measurement_schema(Dimension dimension) {
  return {{"type", "string"},
          {"pattern",
           fmt::format(R"(^-?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)? *({})?$)",
                       fmt::join(units_of(dimension), "|"))}};
}

nlohmann::json one_of(nlohmann::json alternatives) {
  return alternatives.size() == 1 ? alternatives.front()
                                  : nlohmann::json{{"anyOf", alternatives}};
}

nlohmann::json schema_of_one(const ValueType& type, Dimension dimension) {
  if (type.kind == ValueType::Kind::text && type.names != nullptr)
    return {{"enum", type.names()}};
  nlohmann::json alternatives =
      nlohmann::json::array({nlohmann::json{{"type", name_of(type.kind)}}});
  if (type.names != nullptr) alternatives.push_back({{"enum", type.names()}});
  if (dimension != Dimension::none) alternatives.push_back(measurement_schema(dimension));
  return one_of(alternatives);
}

}  // namespace

nlohmann::json schema_of(const ValueType& type, Dimension dimension) {
  const nlohmann::json one = schema_of_one(type, dimension);
  if (type.most == 1) return one;
  nlohmann::json list{{"type", "array"}, {"items", one}, {"minItems", type.least}};
  if (type.most != ValueType::any_number) list["maxItems"] = type.most;
  return type.least == 1 ? one_of({one, list}) : list;
}

}  // namespace springcheck
