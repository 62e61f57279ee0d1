#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "comparisons/command_line/options.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/commands/output/result_json.hpp"
#include "comparisons/formats/table.hpp"
#include "comparisons/gates/gate_keys.hpp"
#include "comparisons/gates/gate_output.hpp"
#include "comparisons/names/suggestion.hpp"
#include "comparisons/settings/setting_schema.hpp"
#include "comparisons/sweeps/sweep_schema.hpp"
#include "comparisons/vocabulary/vocabulary.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

/// The JSON schema of all that `--json` prints.
Json result_schema() {
  const Json definitions{{"run", run_schema()},
                         {"gate", gates::report_schema()},
                         {"list", list_schema()},
                         {"table", table_schema()}};
  Json alternatives = Json::array();
  for (auto one = definitions.begin(); one != definitions.end(); ++one)
    alternatives.push_back({{"$ref", "#/definitions/" + one.key()}});
  alternatives.push_back(
      {{"type", "array"}, {"items", {{"$ref", "#/definitions/table"}}}});
  return schema_document("What springcheck prints with --json",
                         {{"anyOf", alternatives}, {"definitions", definitions}});
}

struct Schema {
  std::string_view name;
  Json (*make)();
};
constexpr std::array schemas{Schema{"scene", scene_schema}, Schema{"sweep", sweep_schema},
                             Schema{"gate", gates::gate_schema},
                             Schema{"result", result_schema}};

std::vector<std::string_view> schema_names() {
  std::vector<std::string_view> names;
  for (const Schema& schema : schemas) names.push_back(schema.name);
  return names;
}

ExitStatus print_schema(const std::string& what) {
  const auto schema = std::ranges::find(schemas, what, &Schema::name);
  if (schema == schemas.end())
    refuse_name("springcheck schema", "file", what, schema_names());
  fmt::print("{}\n", schema->make().dump(2));
  return ExitStatus::done;
}

Action declare_schema(CLI::App& parser) {
  const auto what = std::make_shared<std::string>();
  parser.add_option("kind", *what, "of file; result is what --json prints")
      ->required()
      ->type_name(alternatives(schema_names()));
  return [what] { return print_schema(*what); };
}

}  // namespace

Command schema_command() {
  return {.name = "schema",
          .summary = "Print the JSON schema of a kind of file",
          .description = "Editors complete and check files by it.",
          .examples = {{"springcheck schema scene", "the keys of scene files"},
                       {"springcheck schema result",
                        "what commands print as JSON: cases, gates, lists, tables"}},
          .declare = declare_schema};
}

}  // namespace springcheck
