#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/result_json.hpp"
#include "comparisons/gates/gate_keys.hpp"
#include "comparisons/gates/gate_output.hpp"
#include "comparisons/settings/setting_schema.hpp"
#include "comparisons/settings/suggestion.hpp"
#include "comparisons/sweeps/sweep_schema.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

/// Of all that `--json` prints.
Json result_schema() {
  const Json alternatives = {{{"$ref", "#/definitions/run"}},
                             {{"$ref", "#/definitions/gate"}},
                             {{"$ref", "#/definitions/list"}}};
  return schema_document("What springcheck prints with --json",
                         {{"anyOf", alternatives},
                          {"definitions",
                           {{"run", run_schema()},
                            {"gate", gates::report_schema()},
                            {"list", list_schema()}}}});
}

struct Schema {
  std::string_view name;
  Json (*make)();
};
constexpr std::array schemas{Schema{"scene", scene_schema}, Schema{"sweep", sweep_schema},
                             Schema{"gate", gates::gate_schema},
                             Schema{"result", result_schema}};

}  // namespace

ExitStatus schema_command(const std::string& what) {
  std::vector<std::string_view> names;
  for (const auto& [name, make] : schemas) {
    if (name == what) {
      fmt::print("{}\n", make().dump(2));
      return ExitStatus::done;
    }
    names.push_back(name);
  }
  refuse_name("springcheck schema", "file", what, names);
}

}  // namespace springcheck
