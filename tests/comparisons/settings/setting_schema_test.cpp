// The schema of scenes against the readers of the settings.

#include "comparisons/settings/setting_schema.hpp"

#include <boost/test/unit_test.hpp>
#include <optional>
#include <set>

#include "comparisons/settings/scene_file.hpp"
#include "comparisons/settings/toml_values.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/json_schema.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(setting_schema_test)

namespace {

/// Values of all types, as TOML: names of all enumerations among them.
std::vector<std::string> values_of_all_types() {
  std::vector<std::string> all{"true",
                               "false",
                               "7",
                               "0.3",
                               "[5, 5, 5]",
                               "[2, 0.4, 1, 2]",
                               "100",
                               "3",
                               "-2",
                               "0.25",
                               "1e4",
                               "\"5%\"",
                               "\"45 deg\"",
                               "\"10kPa\"",
                               "\"3mm\"",
                               "\"-.5e-3s\"",
                               "\"2 m/s^2\"",
                               "\"a.msh\"",
                               "\"\"",
                               "\"auto\"",
                               "[1.0]",
                               "[1, 2]",
                               "[0.5, 0.75]",
                               "[4, 4, 4]",
                               "[0.1, 1, 2]",
                               "[\"1cm\", 2, 3]",
                               "[\"1kPa\", 0, 3]",
                               "[1, 0.5, 2, 3]",
                               "[0.1, 0, 0, 0, 0, 0, 0, 0, 0]",
                               "[0, 0.2, 0, 0, 0, 0, 0, 0, 0]",
                               "[true]",
                               "[]",
                               "[[1]]",
                               "\"split,plane=0,0,1,0.5\"",
                               "[\"remove,box=0,0,0,1,1,1\"]",
                               "[{kind = \"split\", plane = [0, 0, 1, 0.5]}]",
                               "{kind = \"split\", plane = [0, 0, 1, 0.5]}",
                               "1979-05-27"};
  for (const Setting& setting : all_settings())
    if (setting.access.type.names != nullptr)
      for (const std::string_view name : setting.access.type.names()) {
        const std::string text = '"' + std::string(name) + '"';
        all.push_back(text);
        all.push_back("[" + text + "]");
      }
  return all;
}

/// A run whose other settings are all read, and the value; none where it is refused.
std::optional<RunSettings> read_value(const Setting& setting, const std::string& value) {
  static const RunSettings usual = [] {
    RunSettings run = read_run("compression", {});
    run.common.springs.constants = mss::LatticeConstants{};
    run.common.dynamics.load = {{.time = 1, .fraction = 1}};
    run.common.dynamics.oscillation = Oscillation{.angular_frequency = 1, .cycles = 1};
    return run;
  }();
  RunSettings run = usual;
  const toml::table table = parse_toml("value = " + value, "test.toml");
  const Given given = springcheck::given(*table.get("value"), "test.toml", "value");
  const Dimension dimension = setting.dimension == Dimension::deformation
                                  ? Dimension::fraction
                                  : setting.dimension;
  try {
    setting.access.read(run, given.in_si_units(dimension));
  } catch (const InputError&) {
    return std::nullopt;
  }
  return run;
}

}  // namespace

// Values outside a setting's range, or in a scene that lacks others, are left to the
// program.
BOOST_AUTO_TEST_CASE(what_the_program_reads_the_schema_takes) {
  const nlohmann::json schema = scene_schema();
  const std::vector<std::string> values = values_of_all_types();
  for (const Setting& setting : all_settings()) {
    const std::string key(setting.key);
    int read = 0;
    for (const std::string& value : values) {
      if (!read_value(setting, value)) continue;
      ++read;
      std::string scene = key + " = " + value;
      if (key != "test") scene += "\ntest = 'compression'";
      BOOST_TEST(violations(schema, json_of_toml(scene)) == "", scene);
    }
    BOOST_TEST(read > 0, key);
  }
}

// What is told must have been read: no setting is told as it always was.
BOOST_AUTO_TEST_CASE(every_setting_reaches_what_is_told_of_the_case) {
  const std::vector<std::string> values = values_of_all_types();
  for (const Setting& setting : all_settings()) {
    if (setting.access.told == nullptr || setting.key == "method")
      continue;  // of a request
    std::set<std::string> told;
    for (const std::string& value : values)
      if (const auto run = read_value(setting, value))
        told.insert(setting.access.told(run->common).dump());
    BOOST_TEST(told.size() > 1U, setting.key);
  }
}

BOOST_AUTO_TEST_SUITE_END()
