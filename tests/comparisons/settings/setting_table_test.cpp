// What every entry of the table of settings must be.

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "comparisons/settings/body_checks.hpp"
#include "comparisons/settings/case_json.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/setting.hpp"
#include "comparisons/shipped/shipped.hpp"
#include "meshing/basics/input_error.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(setting_table_test)

namespace {

/// Cases of every method in every shipped scene that takes it, statically and through
/// time.
std::vector<CaseSettings> cases_of_everything() {
  std::vector<CaseSettings> all;
  for (const ShippedFile& file : shipped_scenes()) {
    const std::string scene = std::filesystem::path(file.name).stem().string();
    RunSettings run = read_run(scene, {});
    for (const Method& method : methods())
      for (const auto solver : {std::optional<Solver>{}, std::optional(Solver::verlet)}) {
        CaseSettings settings = run.common;
        settings.method = method;
        settings.solver = solver;
        settings.springs.constants = mss::LatticeConstants{};
        settings.dynamics.history = 2;
        all.push_back(settings);
        settings.body.shape = BodyShape::file;
        all.push_back(settings);
      }
  }
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(keys_are_declared_once_and_their_companions_exist) {
  std::set<std::string_view> keys;
  for (const Setting& setting : all_settings()) {
    BOOST_TEST(keys.insert(setting.key).second, setting.key);
    BOOST_TEST((setting.beside.empty() || find_setting(setting.beside) != nullptr),
               setting.key);
    BOOST_TEST(!setting.help.empty(), setting.key);
    BOOST_TEST(!setting.group.name.empty(), setting.key);
    BOOST_TEST((setting.access.read != nullptr), setting.key);
    const Readers& readers = setting.readers;
    const bool may_be_refused = readers.unread != Unread::accepted;
    BOOST_TEST((!may_be_refused || readers.of_methods || !readers.without.empty()),
               setting.key);
  }
}

BOOST_AUTO_TEST_CASE(defaults_are_what_users_could_write) {
  const RunSettings usual = read_run("compression", {});
  for (const Setting& setting : all_settings()) {
    if (setting.otherwise.empty()) continue;
    RunSettings run = usual;
    BOOST_CHECK_NO_THROW(
        setting.access.read(run, Given::from_text("default", setting.otherwise)));
    const auto reader = [&](const MethodChoice& choice) {
      return reads(with_method(run.common, choice), setting);
    };
    if (setting.access.told != nullptr && std::ranges::any_of(run.methods, reader))
      BOOST_TEST(setting.access.told(run.common) == setting.access.told(usual.common),
                 setting.key);
  }
}

// Nothing is told that is not declared, and everything that is declared as told is told
// by some case.
BOOST_AUTO_TEST_CASE(cases_tell_the_declared_settings_and_no_others) {
  std::set<std::string> told, declared;
  for (const CaseSettings& settings : cases_of_everything()) {
    const nlohmann::json json = settings_json(settings);
    for (const auto& [key, value] : json.items()) told.insert(key);
  }
  for (const Setting& setting : all_settings())
    if (setting.access.told != nullptr) declared.emplace(setting.key);
  declared.insert("scene");
  BOOST_TEST(told == declared, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_setting_that_is_not_declared_cannot_be_read) {
  BOOST_CHECK_THROW(find(Settings{}, "yuong"), std::logic_error);
  BOOST_TEST(find(Settings{}, "young") == nullptr);
}

BOOST_AUTO_TEST_CASE(a_setting_that_replaces_another_is_not_alone) {
  for (const Setting& setting : all_settings())
    if (setting.replaces != 0)
      BOOST_TEST(
          std::ranges::count(all_settings(), setting.replaces, &Setting::replaces) > 1,
          setting.key);
}

BOOST_AUTO_TEST_SUITE_END()
