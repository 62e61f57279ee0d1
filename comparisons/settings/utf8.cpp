#include "comparisons/settings/utf8.hpp"

#include <nlohmann/json.hpp>
#include <tuple>

namespace springcheck {

bool is_utf8(const std::string& text) {
  try {
    std::ignore = nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

}  // namespace springcheck
