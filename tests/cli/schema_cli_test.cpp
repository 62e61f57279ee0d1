// What `springcheck schema` prints, held against the files that are shipped and those
// that the program refuses. What --json prints is held against its schema wherever a test
// of this folder runs the program, see run_springcheck.

#include <boost/test/unit_test.hpp>
#include <fstream>

#include "tests/cli/program.hpp"
#include "tests/json_schema.hpp"

BOOST_AUTO_TEST_SUITE(schema_cli_test)

namespace {

Json schema_of(const std::string& kind) {
  return json_of("schema " + kind);
}

std::vector<fs::path> files_in(const fs::path& files) {
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(files)) all.push_back(entry.path());
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(shipped_files_are_what_their_schemas_say) {
  for (const std::string kind : {"scene", "sweep", "gate"}) {
    const Json schema = schema_of(kind);
    std::vector<fs::path> files = files_in("comparisons/shipped/" + kind + "s");
    BOOST_TEST(files.size() > 1U);
    if (kind == "sweep") files.emplace_back("examples/gates/cases.toml");
    if (kind == "gate") files.emplace_back("examples/gates/gates.toml");
    for (const fs::path& file : files)
      BOOST_TEST(violations(schema, json_of_toml(text_of(file))) == "", file);
  }
}

BOOST_AUTO_TEST_CASE(schemas_refuse_what_the_program_refuses) {
  const std::vector<std::array<const char*, 2>> files{{
      {"scene", ""},
      {"scene", "young = 1"},
      {"scene", "test = 'compression'\nyuong = 1"},
      {"scene", "test = 'compression'\nyoung = '10kg'"},
      {"scene", "test = 'compression'\nyoung = true"},
      {"scene", "test = 'compression'\nyoung = [1]"},
      {"scene", "test = 'compression'\nsolver = 'statc'"},
      {"scene", "test = 'compression'\nmethod = 'mss-cff'"},
      {"scene", "test = 'compression'\ncells = [4, 4]"},
      {"scene", "test = 'compression'\ncells = [4, 4, 4, 4]"},
      {"scene", "test = 'compression'\ncells = [4, 4.5, 4]"},
      {"scene", "test = 'compression'\ncells = [4.0, 4, 4]"},
      {"scene", "test = 'bending'\ngravity = [1, 2]"},
      {"scene", "test = 'compression'\nseed = 1.5"},
      {"scene", "test = 'compression'\nlaw = [1, 2, 3]"},
      {"scene", "test = 'compression'\nforce-dt = 1"},
      {"scene", "test = 'compression'\ndt = 'automatic'"},
      {"sweep", "scene = 1"},
      {"sweep", "nu = {from = 0, to = 1}"},
      {"sweep", "nu = {from = 0, to = 1, count = 1}"},
      {"sweep", "test = 'compression'"},
      {"gate", "fixed = true"},
      {"gate", "[[gate]]\nname = 'a'"},
      {"gate", "[[gate]]\nname = 'a'\nreason = 'b'\nequal = 1"},
      {"gate", "[[gate]]\nname = 'a'\nreason = 'b'\nexpect = 'okay'"},
  }};
  for (const auto& [kind, text] : files) {
    const std::string name = std::string("not-") + kind + ".toml";
    std::ofstream(folder / name) << text << '\n';
    BOOST_TEST(violations(schema_of(kind), json_of_toml(text)) != "", text);
    const std::string command = kind == std::string("scene") ? "run " + name
                                : kind == std::string("sweep")
                                    ? "sweep " + name + " --out a.h5"
                                    : "gate " + name + " a.h5";
    BOOST_TEST(run_springcheck(command).status == 2, command << ": " << text);
  }
}

// JSON of gates and of what others measured is printed by other tests, whose fields are
// judged there; that of runs, too.
BOOST_AUTO_TEST_CASE(results_that_lack_or_add_a_field_are_refused) {
  const Json schema = schema_of("result");
  const Json whole = json_of("run compression --method mss-cf --cells 1,1,1 --json");
  BOOST_TEST(violations(schema, whole) == "");
  const auto changed = [&](auto&& change) {
    Json other = whole;
    change(other["results"][0]);
    return violations(schema, other);
  };
  BOOST_TEST(changed([](Json& result) { result.erase("torque"); }) != "");
  BOOST_TEST(changed([](Json& result) { result["torqe"] = nullptr; }) != "");
  BOOST_TEST(changed([](Json& result) { result["plate_force"] = "1"; }) != "");
  BOOST_TEST(changed([](Json& result) { result["status"] = "fine"; }) != "");
  BOOST_TEST(changed([](Json& result) { result["force"].push_back(1); }) != "");
}

BOOST_AUTO_TEST_CASE(unknown_schemas_are_named_with_those_there_are) {
  expect_bad_input("schema sceen",
                   "springcheck schema: unknown file 'sceen', did you mean 'scene'? "
                   "expected one of scene, sweep, gate, result");
}

BOOST_AUTO_TEST_SUITE_END()
