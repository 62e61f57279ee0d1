#include "comparisons/gates/bless.hpp"

#include <boost/test/unit_test.hpp>
#include <variant>

#include "comparisons/gates/gate_check.hpp"
#include "comparisons/gates/gate_file.hpp"
#include "tests/comparisons/gates/example_gates.hpp"

using namespace springcheck;
using namespace springcheck::gates;

BOOST_AUTO_TEST_SUITE(bless_test)

namespace {

const std::string file_with_comments =
    "# Figures of last year\n"
    "where = { method = 'mss-cf' }   # all of them\n\n"
    "[[gate]]\n"
    "name = 'ü force'   # moved\n"
    "reason = 'r'\n"
    "where.nu = 0.25\n"
    "measure = 'plate_force'\n"
    "equals   =  +1.2e0 # N\r\n"
    "absolute = 1e-9\n\n"
    "gate2 = 1\n";

}  // namespace

BOOST_AUTO_TEST_CASE(blessing_rewrites_the_value_and_nothing_else) {
  std::string text = file_with_comments;
  text.resize(text.find("gate2"));
  const auto all = parse_gates(text, "gates.toml");
  const std::vector<Outcome> outcomes{check(all[0], table(), "file.h5")};
  const auto values = to_bless(all, outcomes);
  BOOST_TEST_REQUIRE(values.size() == 1U);
  BOOST_TEST(values[0].old_value == 1.2);
  BOOST_TEST(values[0].new_value == 1.3);
  std::string expected = text;
  expected.replace(expected.find("+1.2e0"), 6, "1.3");
  BOOST_TEST(with_blessed(text, "gates.toml", all, values) == expected);
}

BOOST_AUTO_TEST_CASE(a_value_on_a_line_with_others_is_found) {
  const std::string text =
      "gate = [{ name = 'ä', reason = 'ö', where = { method = 'mss-cf', nu = 0.1 }, "
      "measure = 'plate_force', equals = 1, absolute = 0.1 },\n { name = 'b', reason = "
      "'r', where = { method = 'mss-cf', nu = 0.25 }, measure = 'plate_force', equals = "
      "1_0, absolute = 0.1 }]";
  const auto all = parse_gates(text, "gates.toml");
  std::vector<Outcome> outcomes;
  for (const Gate& gate : all) outcomes.push_back(check(gate, table(), "file.h5"));
  const std::string blessed =
      with_blessed(text, "gates.toml", all, to_bless(all, outcomes));
  const auto again = parse_gates(blessed, "gates.toml");
  BOOST_TEST(std::get<Stored>(again[0].comparison).value == 1.2);
  BOOST_TEST(std::get<Stored>(again[1].comparison).value == 1.3);
}

// Within the band, null, another status, another's figure, and other kinds of band.
BOOST_AUTO_TEST_CASE(what_is_no_new_value_is_not_blessed) {
  for (const std::string& gate : std::vector<std::string>{
           force + "equals = 1.2\nabsolute = 0.2",
           null_case + "measure = 'volume_error'\nequals = 1\nabsolute = 1",
           "where = { method = 'mss-nfd' }\nmeasure = 'plate_force'\nequals = 1\n"
           "absolute = 0.01",
           force + "equals = 1.2\nabsolute = 0.01\nfixed = true", force + "at_most = 1",
           cf + "measure = 'force.x'\nequals = 1\nrelative = 0.01"}) {
    const auto all = parse_gates(head + gate, "gates.toml");
    BOOST_TEST(to_bless(all, {check(all[0], table(), "file.h5")}).empty(), gate);
  }
}

BOOST_AUTO_TEST_SUITE_END()
