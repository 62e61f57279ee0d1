#include "comparisons/settings/run_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "comparisons/settings/body_checks.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/settings/setting_values.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

bool is_of_scene(const Given& given, const std::string& file) {
  return given.place().starts_with(file + ":");
}

/// Keeps one of the settings that replace each other: an option's, a sweep's or a table's
/// rather than the scene's, which is `file`. Throws InputError where two have equal
/// rights.
void keep_one_of_each(Settings& settings, const std::string& file) {
  std::map<int, const Setting*> kept;
  for (const Setting& setting : all_settings()) {
    const Given* given = find(settings, setting.key);
    if (setting.replaces == 0 || given == nullptr) continue;
    const auto [place, is_first] = kept.try_emplace(setting.replaces, &setting);
    if (is_first) continue;
    const Given& other = settings.at(std::string(place->second->key));
    if (is_of_scene(other, file) == is_of_scene(*given, file))
      given->refuse("no value beside that of " + other.place() +
                    ", which it would replace");
    const Setting* replaced = &setting;
    if (is_of_scene(other, file)) std::swap(replaced, place->second);
    settings.erase(std::string(replaced->key));
    for (const Setting& further : all_settings())  // of the scene, which go with it
      if (const Given* its = find(settings, further.key);
          its != nullptr && further.beside == replaced->key && is_of_scene(*its, file))
        settings.erase(std::string(further.key));
  }
}

/// Takes settings of the scene, which is `file`, away in whose place others stand: those
/// of its block, where there is a mesh. Throws InputError for both in one place, and for
/// the first where it is to change the scene.
void take_what_stands_instead(Settings& settings, const std::string& file) {
  for (const Setting& setting : all_settings()) {
    const Given *given = find(settings, setting.key),
                *other = find(settings, setting.instead);
    if (given == nullptr || other == nullptr) continue;
    if (!is_of_scene(*given, file) || is_of_scene(*other, file))
      given->refuse(fmt::format("no {} beside {} '{}', which stands in its place",
                                setting.key, setting.instead, other->text()));
    settings.erase(std::string(setting.key));
  }
}

void check_beside(const Settings& settings) {
  for (const auto& [key, given] : settings)
    if (const std::string_view other = find_setting(key)->beside;
        !other.empty() && find(settings, other) == nullptr)
      given.refuse(fmt::format("{0} beside {1}: no {1} without {0}", other, key));
  const Given *ratio = find(settings, "dt-ratio"), *dt = find(settings, "dt");
  if (ratio != nullptr && dt != nullptr && !(dt->is_text() && dt->text() == "auto"))
    ratio->refuse("no dt-ratio beside a dt, which it would replace");
}

/// Refuses settings that the test does not have.
void check_test(const Settings& settings, Test test) {
  for (const auto& [key, given] : settings) {
    const auto has = find_setting(key)->has;
    if (has == nullptr || has(test)) continue;
    const auto& tests = value_names<Test>;
    const auto first = std::ranges::find_if(tests, has, &TestName::value);
    if (std::ranges::count_if(tests, has, &TestName::value) == 1)
      given.refuse(fmt::format("no {} but in {}", key, first->name));
    given.refuse(fmt::format("no {} in {}", key, name_of(test)));
  }
}

/// Whether a value is that of the setting's own option, not that of `--over`, some of
/// whose points may read it.
bool is_own_option(const Given& given, const std::string& key) {
  return given.place() == "--" + key;
}

bool is_read(const RunSettings& run, const Setting& setting) {
  return runs(run, [&](const CaseSettings& c) { return is_reader(c, setting); });
}

/// Refuses settings that the run's test, methods and reference do not read.
void check_read(const RunSettings& run, const Settings& settings) {
  for (const auto& [key, given] : settings) {
    const Setting& setting = *find_setting(key);
    const bool matters = setting.readers.unread == Unread::refused ||
                         (setting.readers.unread == Unread::refused_as_option &&
                          is_own_option(given, key));
    if (matters && !is_read(run, setting))
      given.refuse(fmt::format("no {} {}", key, without_readers(setting)));
  }
}

/// Refuses a method that is there twice, whether its element is named or is that of the
/// setting; the setting must be left to some method to read.
void check_elements(const RunSettings& run, const Settings& settings) {
  const auto names_element = [](const MethodChoice& choice) {
    return choice.element.has_value();
  };
  const auto has_open_element = [&](const MethodChoice& choice) {
    return reads(choice.method, "element") && !names_element(choice);
  };
  const Given& methods = *find(settings, "method");
  const Given* element = find(settings, "element");
  if (element != nullptr && is_own_option(*element, "element") &&
      std::ranges::any_of(run.methods, names_element) &&
      std::ranges::none_of(run.methods, has_open_element))
    element->refuse("no element beside methods that name theirs");
  std::set<std::pair<std::string, std::string>> known;
  for (const MethodChoice& choice : run.methods) {
    const std::string of_run(run.common.elements.element.name);
    const std::string name = choice.element ? std::string(choice.element->name) : of_run;
    if (reads(choice.method, "element") &&
        !known.insert({choice.method.name, name}).second)
      throw InputError(methods.place(), "", "each method once",
                       fmt::format("'{}:{}' twice", choice.method.name, name));
  }
}

/// Refuses a negative load under which what is drawn apart comes together.
void check_reversed(const RunSettings& run, const Settings& settings) {
  const CaseSettings& common = run.common;
  if (common.dynamics.load.empty()) return;
  const double least =
      std::ranges::min_element(common.dynamics.load, {}, &dynamics::LoadPoint::fraction)
          ->fraction;
  if (least >= 0) return;
  const Given* given = find(settings, "load-fractions");
  if (given == nullptr) given = find(settings, "angular-frequency");
  const bool pulls = common.test == Test::tension || common.test == Test::uniaxial;
  if (pulls && 1 + least * *common.deformation <= 0)
    given->refuse("no load that presses the plates through each other");
  if (common.test == Test::affine && turns_inside_out(least * common.gradient))
    given->refuse("no load that turns the body inside out");
}

Dimension dimension_of(const Setting& setting, Test test) {
  if (setting.dimension != Dimension::deformation) return setting.dimension;
  return entry_of(test).turns ? Dimension::angle : Dimension::fraction;
}

/// Whether another setting is given that stands in place of this one.
bool is_replaced(const Setting& setting, const Settings& settings) {
  return setting.replaces != 0 &&
         std::ranges::any_of(all_settings(), [&](const Setting& other) {
           return other.replaces == setting.replaces &&
                  find(settings, other.key) != nullptr;
         });
}

bool is_needed(const RunSettings& run, const Setting& setting) {
  if (setting.is_needed != nullptr) return setting.is_needed(run);
  return !setting.readers.of_methods || is_read(run, setting);
}

void read(const Setting& setting, RunSettings& run, const Settings& settings,
          const std::string& file) {
  if (const Given* given = find(settings, setting.key))
    setting.access.read(run, given->in_si_units(dimension_of(setting, run.common.test)));
  else if (!setting.otherwise.empty())
    setting.access.read(run, Given::from_text("default", setting.otherwise));
  else if (!setting.needed.empty() && !is_replaced(setting, settings) &&
           (setting.has == nullptr || setting.has(run.common.test)) &&
           is_needed(run, setting))
    throw InputError(file + ":1:1", fmt::format("key '{}'", setting.key), setting.needed,
                     "none");
}

}  // namespace

bool runs(const RunSettings& run,
          const std::function<bool(const CaseSettings&)>& is_one) {
  const auto is_one_of_run = [&](const MethodChoice& choice) {
    return is_one(with_method(run.common, choice));
  };
  return std::ranges::any_of(run.methods, is_one_of_run) ||
         (run.reference && is_one(with_reference_method(run.common, *run.reference)));
}

RunSettings make_run_settings(const std::string& name, const std::string& file,
                              const GivenSettings& given) {
  Settings settings;
  for (const auto& [key, value] : given) settings.insert_or_assign(key, value);
  take_what_stands_instead(settings, file);
  keep_one_of_each(settings, file);
  check_beside(settings);
  RunSettings run{};
  run.common.scene = name;
  run.common.material.young_modulus = 1;  // of tissue alone, which does not read it
  const Setting& test = *find_setting("test");
  read(test, run, settings, file);
  check_test(settings, run.common.test);
  for (const Setting& setting : all_settings())
    if (&setting != &test) read(setting, run, settings, file);
  check_read(run, settings);
  check_body(run.common, settings, file);
  check_elements(run, settings);
  check_reversed(run, settings);
  const bool is_file = run.common.body.shape == BodyShape::file;
  run.cells_place = find(settings, is_file ? "mesh" : "cells")->place();
  return run;
}

}  // namespace springcheck
