#include "comparisons/vocabulary/vocabulary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "comparisons/chart/chart_tables.hpp"
#include "comparisons/command_line/exit_status.hpp"
#include "comparisons/gates/gate_keys.hpp"
#include "comparisons/measures/measure_list.hpp"
#include "comparisons/methods/methods.hpp"
#include "comparisons/results/layout.hpp"
#include "comparisons/settings/case_json.hpp"
#include "comparisons/settings/cut_keys.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting_schema.hpp"
#include "comparisons/shipped/shipped.hpp"
#include "comparisons/stability/failure.hpp"
#include "comparisons/tables/catalogue.hpp"

namespace springcheck {
namespace {

using Json = nlohmann::ordered_json;

/// {name: description}, of values that have both.
template <class Range>
Json described(const Range& range) {
  Json entries;
  for (const auto& one : range) entries[std::string(one.name)] = one.description;
  return entries;
}

Json list_of_methods() {
  Json entries;
  for (const Method& method : methods()) {
    const Method& of_law = followed_law(method, method);
    std::vector<std::string_view> cells, solvers;
    for (const CellType type : method.cells) cells.push_back(name_of(type));
    for (const Solver solver : method.solvers) solvers.push_back(name_of(solver));
    entries[method.name] = {
        {"family", name_of(method.family)},
        {"description", method.description},
        {"covers", method.covers},
        {"source", method.source},
        {"cells", cells},
        {"solvers", solvers},
        {"settings", method.reads},
        {"lattice", method.lattice.has_value()},
        {"elastic", method.is_elastic},
        {"locks", method.locks},
        {"law", of_law.law},
        {"corrects_volume", method.corrects_volume},
        {"foremost", method.foremost},
        {"of_thesis", method.of_thesis},
        {"follows_solver", method.follows_solver},
        {"bar_limit",
         {{"strain", of_law.bar_limit.strain}, {"words", of_law.bar_limit.words}}},
        {"at_rest", method.at_rest},
        {"colour", method.look.colour},
        {"mark", method.look.mark}};
  }
  return entries;
}

/// {name: {"unit": ..., "description": ...}}.
Json with_units(const std::vector<Described>& range) {
  Json entries;
  for (const Described& one : range)
    entries[std::string(one.name)] = {{"unit", one.unit},
                                      {"description", one.description}};
  return entries;
}

Json list_of_measures() {
  Json entries;
  for (const Measure& measure : measure_list) {
    std::vector<std::string_view> tests;
    for (const TestName& test : value_names<Test>)
      if (measure.traits.is_of(test)) tests.push_back(test.name);
    entries[std::string(measure.name)] = {{"label", measure.label},
                                          {"unit", measure.unit},
                                          {"shown_unit", shown_unit(measure)},
                                          {"shown_factor", shown_factor(measure)},
                                          {"components", component_count(measure)},
                                          {"tests", tests},
                                          {"compared", name_of(measure.traits.compared)},
                                          {"time", measure.traits.is_time},
                                          {"description", measure.description}};
  }
  return entries;
}

Json list_of_tables() {
  Json entries;
  for (const CatalogueEntry& entry : catalogue())
    entries[std::string(entry.name)] = {{"title", entry.title},
                                        {"minutes", entry.minutes},
                                        {"source", name_of(entry.source)},
                                        {"section", entry.section},
                                        {"description", entry.description}};
  return entries;
}

Json list_of_tests() {
  Json entries;
  for (const TestName& test : value_names<Test>)
    entries[std::string(test.name)] = {{"answer", test.answer},
                                       {"passive", test.passive},
                                       {"turns", test.turns},
                                       {"description", test.description}};
  return entries;
}

Json list_of_statuses() {
  Json entries;
  for (const auto& status : value_names<Status>)
    entries[std::string(status.name)] = {{"equilibrium", has_equilibrium(status.value)},
                                         {"said", status.said},
                                         {"description", status.description}};
  return entries;
}

/// The first sentence of the comment that a TOML file begins with, without its full stop.
std::string first_sentence(std::string_view text) {
  std::string comment;
  while (text.starts_with("# ")) {
    const std::size_t end = text.find('\n');
    comment += fmt::format("{}{}", comment.empty() ? "" : " ", text.substr(2, end - 2));
    text.remove_prefix(std::min(end, text.size() - 1) + 1);
  }
  std::size_t stop = comment.find(". ");
  while (stop != std::string::npos &&
         !(comment[stop + 2] >= 'A' && comment[stop + 2] <= 'Z'))
    stop = comment.find(". ", stop + 1);
  if (stop == std::string::npos && comment.ends_with('.')) stop = comment.size() - 1;
  return comment.substr(0, stop);
}

/// Shipped TOML files by their names, each with what describes it.
Json shipped(const std::vector<ShippedFile>& files) {
  Json entries;
  for (const ShippedFile& file : files)
    entries[std::filesystem::path(file.name).stem().string()] = first_sentence(file.text);
  return entries;
}

/// What the cases of a scene read, as result files hold it: in SI units.
Json values_of_scene(const std::string& name) {
  Json values = Json::object();
  for (const Request& request : requests(read_run(name, {})))
    values.update(Json(settings_json(request.settings)));
  for (const char* of_one_case : {"scene", "method"}) values.erase(of_one_case);
  return values;
}

Json list_of_scenes() {
  const Json descriptions = shipped(shipped_scenes());
  Json entries;
  for (auto scene = descriptions.begin(); scene != descriptions.end(); ++scene)
    entries[scene.key()] = {{"description", scene.value()},
                            {"values", values_of_scene(scene.key())}};
  return entries;
}

Json list_of_elements() {
  Json entries;
  for (const ElementName& element : elements())
    entries[std::string(element.name)] = {{"description", element.description},
                                          {"locks", element.locks}};
  return entries;
}

/// "hooke": "small-strain Hooke (fem-hooke)".
Json materials() {
  Json entries;
  for (const Method& method : methods())
    if (!method.law.empty())
      entries[method.name.substr(method.name.find('-') + 1)] =
          fmt::format("{} ({})", method.law, method.name);
  return entries;
}

/// null where there may be any number of them.
Json most_of(const ValueType& type) {
  return type.most == ValueType::any_number ? Json() : Json(type.most);
}

/// The names that there are; null where any text or number may stand.
Json values_of(const ValueType& type) {
  return type.names == nullptr ? Json() : Json(type.names());
}

Json settings() {
  Json entries;
  for (const Setting& setting : all_settings())
    entries[std::string(setting.key)] = {
        {"group", setting.group.name},
        {"option", is_option(setting)},
        {"units", units_of(setting.dimension)},
        {"kind", name_of(setting.access.type.kind)},
        {"least", setting.access.type.least},
        {"most", most_of(setting.access.type)},
        {"values", values_of(setting.access.type)},
        {"si_unit", si_unit_of(setting.dimension)},
        {"column", setting.access.told != nullptr},
        {"beside", setting.beside},
        {"label", setting.label.empty() ? setting.key : setting.label},
        {"usual_axis", setting.usual_axis},
        {"variant", setting.variant},
        {"default", setting.otherwise.empty() ? setting.default_text : setting.otherwise},
        {"description", help_of(setting)}};
  return entries;
}

Json failures() {
  Json entries;
  for (const FailureName& failure : value_names<Failure>)
    entries[std::string(failure.name)] = {{"letter", std::string(1, failure.letter)},
                                          {"description", failure.description}};
  return entries;
}

struct List {
  const char* name;
  Json (*make)();
};

constexpr std::array lists{
    List{"methods", list_of_methods},
    List{"scenes", list_of_scenes},
    List{"sweeps", [] { return shipped(shipped_sweeps()); }},
    List{"cell-types", [] { return described(cell_patterns()); }},
    List{"elements", list_of_elements},
    List{"materials", materials},
    List{"settings", settings},
    List{"tables", list_of_tables},
    List{"tests", list_of_tests},
    List{"measures", list_of_measures},
    List{"compared", [] { return described(value_names<Compared>); }},
    List{"statuses", list_of_statuses},
    List{"failures", failures},
    List{"cut-keys", [] { return described(cut_keys()); }},
    List{"gate-keys", [] { return described(gates::gate_keys()); }},
    List{"result-file", [] { return described(file_layout()); }},
    List{"columns", [] { return with_units(case_columns()); }},
    List{"exit-statuses", [] { return described(value_names<ExitStatus>); }}};

}  // namespace

Json list_schema() {
  const Json text{{"type", "string"}};
  const Json entry{{"anyOf",
                    {text,
                     {{"type", "object"},
                      {"properties", {{"description", text}}},
                      {"required", {"description"}}}}}};
  Json properties;
  for (const List& list : lists)
    properties[list.name] = {{"type", "object"}, {"additionalProperties", entry}};
  Json schema = schema_of_object(properties);
  schema["minProperties"] = 1;
  return schema;
}

Json list_json() {
  Json all;
  for (const List& list : lists) all[list.name] = list.make();
  return all;
}

}  // namespace springcheck
