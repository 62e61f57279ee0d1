#include "comparisons/gates/gate_output.hpp"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "comparisons/gates/gate_check.hpp"
#include "comparisons/gates/gate_file.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/comparisons/gates/example_gates.hpp"

using namespace springcheck;
using namespace springcheck::gates;

BOOST_AUTO_TEST_SUITE(gate_output_test)

BOOST_AUTO_TEST_CASE(junit_is_well_formed_and_counts) {
  const std::string text =
      head + force + "at_most = 1\n" +
      "[[gate]]\nname = '<b> & \"c\"'\nreason = \"it's < 5 \\u0001%\"\n" + cf +
      "measure = 'plate_force'\nat_most = 2\n" +
      "[[gate]]\nname = 'none'\nreason = 'r'\nwhere = { nu = 0.3 }\nexpect = 'ok'\n";
  std::string refused;
  try {
    parse_gates(text, "gates.toml");
  } catch (const InputError& error) {
    refused = error.what();
  }
  BOOST_TEST(
      refused.find("reason: expected a text of one line, got control characters") !=
          std::string::npos,
      refused);

  std::string good = text;
  good.erase(good.find("\\u0001"), 6);
  Report report{.gates_name = "a & b",
                .gates_file = "gates.toml",
                .results_file = "file.h5",
                .gates = parse_gates(good, "gates.toml"),
                .outcomes = {},
                .others = {{"0123456789ab", 2}},
                .revisions = Revisions::all,
                .note = "2 of 0123456789ab"};
  for (const Gate& gate : report.gates)
    report.outcomes.push_back(check(gate, table(), "file.h5"));
  report.outcomes[0].explanation += "\x01<]]>";
  std::stringstream xml;
  write_junit(xml, report);
  boost::property_tree::ptree read;
  boost::property_tree::read_xml(xml, read);
  const auto& suite = read.get_child("testsuites.testsuite");
  BOOST_TEST(suite.get<std::string>("<xmlattr>.name") == "a & b");
  BOOST_TEST(suite.get<int>("<xmlattr>.tests") == 3);
  BOOST_TEST(suite.get<int>("<xmlattr>.failures") == 1);
  BOOST_TEST(suite.get<int>("<xmlattr>.errors") == 1);
  BOOST_TEST(suite.get<std::string>("testcase.failure.<xmlattr>.type") == "falls short");
  const auto told = suite.get<std::string>("properties.property.<xmlattr>.value");
  BOOST_TEST(told.find("2 of 0123456789ab") != std::string::npos, told);
  std::vector<std::string> names;
  for (const auto& [tag, test] : suite)
    if (tag == "testcase") names.push_back(test.get<std::string>("<xmlattr>.name"));
  BOOST_TEST(names == (std::vector<std::string>{"g", "<b> & \"c\"", "none"}),
             boost::test_tools::per_element());

  const auto json = report_json(report);
  BOOST_TEST(json["pass"] == 1);
  BOOST_TEST(json["verdicts"][2]["verdict"] == "no case");
  BOOST_TEST(json["verdicts"][2]["got"].is_null());
  BOOST_TEST(json["verdicts"][1]["got"] == 1.3);
}

BOOST_AUTO_TEST_SUITE_END()
