#include "comparisons/settings/case_json.hpp"

#include <nlohmann/json.hpp>

#include "comparisons/settings/setting.hpp"

namespace springcheck {

nlohmann::json settings_json(const CaseSettings& settings) {
  nlohmann::json json{{"scene", settings.scene}};
  for (const Setting& setting : all_settings()) {
    if (setting.access.told == nullptr || !reads(settings, setting)) continue;
    if (nlohmann::json value = setting.access.told(settings); !value.is_null())
      json[std::string(setting.key)] = std::move(value);
  }
  for (const auto& [key, value] : settings.method.told) json[key] = value;
  return json;
}

}  // namespace springcheck
