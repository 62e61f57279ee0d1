#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "comparisons/settings/value_type.hpp"

namespace springcheck::gates {

struct GateKey {
  std::string_view name;
  ValueType type;
  std::string_view description;
};

/// Every key of a [[gate]], and what it means.
const std::vector<GateKey>& gate_keys();

/// JSON schema of gate files.
nlohmann::ordered_json gate_schema();

}  // namespace springcheck::gates
