#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

#include "comparisons/gates/gate_check.hpp"
#include "comparisons/gates/gate_file.hpp"
#include "comparisons/gates/gate_output.hpp"
#include "comparisons/shipped/shipped.hpp"
#include "meshing/input_error.hpp"

using namespace springcheck;
using namespace springcheck::gates;
namespace data = boost::unit_test::data;

BOOST_AUTO_TEST_SUITE(gates_test)

namespace {

constexpr double null = std::numeric_limits<double>::quiet_NaN();

/// A result file's table as it would be read: nu .1 to .4 of mss-cf, and finite elements
/// at nu .25 on three grids, whose forces 1 + h^2 converge with order 2.
Columns table() {
  Columns cases;
  cases.rows = 7;
  cases.texts["key"] = {"a", "b", "c", "d", "e", "f", "g"};
  cases.texts["scene"] = std::vector<std::string>(7, "compression");
  cases.texts["method"] = {"mss-cf", "mss-cf", "mss-cf", "mss-nfd", "fem", "fem", "fem"};
  cases.texts["element"] = {"", "", "", "", "q1", "q1", "q1"};
  cases.texts["status"] = {"ok", "ok", "ok", "wrinkled", "ok", "ok", "ok"};
  cases.texts["reason"] = {"", "", "", "a free face zigzags", "", "", ""};
  cases.numbers["nu"] = {1, {0.1, 0.25, 0.4, 0.25, 0.25, 0.25, 0.25}};
  cases.numbers["deformation"] = {1, std::vector<double>(7, 0.05)};
  cases.numbers["cells"] = {
      3, {4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 2, 2, 2, 4, 4, 4, 8, 8, 8}};
  cases.numbers["volume_error"] = {1, {0.043, 0.032, null, 0.033, 0.03, 0.03, 0.03}};
  cases.numbers["plate_force"] = {1, {1.2, 1.3, 1.5, 1.1, 1.25, 1.0625, 1.015625}};
  cases.numbers["force"] = {
      3, {0, 0, -1.2, 0, 0, -1.3, 0, 0, -1.5, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1}};
  cases.numbers["solve_wall_s"] = {1, {1, 2, 3, 4, 5, 8, 7}};
  cases.numbers["provenance"] = {1, {0, 0, 1, 0, 0, 0, 0}};
  return cases;
}

const std::string head = "[[gate]]\nname = 'g'\nreason = 'r'\n";
const std::string cf = "where = { method = 'mss-cf', nu = 0.25 }\n";

/// The same simulations beside one reference and then beside another, from which their
/// deviations differ.
Columns beside_two_references() {
  Columns cases = table();
  const auto twice = [](auto& values) {
    const auto once = values;
    values.insert(values.end(), once.begin(), once.end());
  };
  for (auto& [name, texts] : cases.texts) twice(texts);
  for (auto& [name, column] : cases.numbers) twice(column.values);
  cases.texts["reference"] = std::vector<std::string>(7, "fem-hooke:q2");
  cases.texts["reference"].resize(14, "fem-stvk:q2");
  cases.numbers["deviation_max"] = {1, std::vector<double>(7, 0.001)};
  cases.numbers["deviation_max"].values.resize(14, 0.002);
  cases.rows = 14;
  return cases;
}

Outcome outcome_of(const std::string& gate, const Columns& cases = table()) {
  return check(parse_gates(head + gate, "gates.toml").front(), cases, "file.h5");
}

struct Example {
  std::string gate;
  Judgement verdict;
  std::string explanation;  // a part of it
};
std::ostream& operator<<(std::ostream& out, const Example& example) {
  return out << example.gate;
}

const std::string force = cf + "measure = 'plate_force'\n";
const std::string grids = "where = { method = 'fem' }\nmeasure = 'plate_force'\n";
const std::string fine = "{ method = 'fem', cells = [4, 4, 4] }\n";

const std::vector<Example> examples{
    // Stored values
    {force + "equals = 1.2\nabsolute = 0.11", Judgement::pass, ""},
    {force + "equals = 1.2\nabsolute = 0.09", Judgement::falls_short, "outside the band"},
    {force + "equals = 1.2\nrelative = 0.09", Judgement::pass, ""},
    {force + "equals = 1.2\nrelative = 0.09\nabsolute = 1e-3", Judgement::pass, ""},
    {force + "equals = -1.2\nrelative = 0.09", Judgement::falls_short, "outside"},
    {cf + "measure = 'force.z'\nequals = -1.3\nabsolute = 1e-9", Judgement::pass, ""},
    // One or two edges
    {force + "at_least = 1.3\nat_most = 1.4", Judgement::pass, ""},
    {force + "at_most = 1.29", Judgement::falls_short, "outside"},
    {force + "at_least = 1.31", Judgement::falls_short, "outside"},
    // Another method, which need not read all that the own case's does
    {force + "against = " + fine + "relative = 0.25", Judgement::pass, ""},
    {force + "against = " + fine + "relative = 0.2", Judgement::falls_short, "outside"},
    {"where = { method = 'fem', element = 'q1', cells = [4, 4, 4] }\n"
     "measure = 'plate_force'\nagainst = { method = 'mss-cf', nu = 0.25 }\nrelative = 1",
     Judgement::pass, ""},
    {force + "against = { measure = 'force.z' }\nabsolute = 2.7", Judgement::pass, ""},
    {force + "against = { method = 'mss-nfd' }\nrelative = 1", Judgement::falls_short,
     "the other case's status is wrinkled (a free face zigzags)"},
    // Ratios; times within one session only
    {cf + "measure = 'solve_wall_s'\nratio_to = " + fine + "at_most = 0.25",
     Judgement::pass, ""},
    {cf + "measure = 'solve_wall_s'\nratio_to = " + fine + "at_most = 0.24",
     Judgement::falls_short, "outside"},
    {cf + "measure = 'solve_wall_s'\nratio_to = { nu = 0.4 }\nat_most = 9",
     Judgement::no_case, "two sessions"},
    {cf + "measure = 'plate_force'\nratio_to = { nu = 0.4 }\nat_most = 1",
     Judgement::pass, ""},
    // Sweeps
    {"where = { method = 'mss-cf' }\nmeasure = 'plate_force'\nalong = 'nu'\n"
     "monotonic = 'increasing'",
     Judgement::pass, ""},
    {"where = { method = 'mss-cf' }\nmeasure = 'plate_force'\nalong = 'nu'\n"
     "monotonic = 'decreasing'",
     Judgement::falls_short, "1.2 at nu = 0.1, then 1.3 at 0.25"},
    {"where = { method = 'mss-cf', nu = [0.1, 0.25] }\nmeasure = 'volume_error'\n"
     "along = 'nu'\nmonotonic = 'decreasing'",
     Judgement::pass, ""},
    {"where = { method = 'mss-cf', nu = [0.1, 0.3] }\nmeasure = 'plate_force'\n"
     "along = 'nu'\nmonotonic = 'increasing'",
     Judgement::no_case, "no case matches nu = 0.3"},
    {"where = { nu = [0.25, 0.4], method = ['mss-cf', 'mss-nfd'] }\n"
     "measure = 'plate_force'\nalong = 'nu'\nmonotonic = 'increasing'",
     Judgement::no_case, "they differ in method"},
    {grids + "along = 'cells'\norder_between = [1.9, 2.1]", Judgement::pass, ""},
    {grids + "along = 'cells'\norder_at_least = 2.1", Judgement::falls_short, "outside"},
    {"where = { method = 'fem' }\nmeasure = 'volume_error'\nalong = 'cells'\n"
     "order_at_least = 1",
     Judgement::falls_short, "show no order"},
    {"where = { method = 'fem', cells = [[2, 2, 2], [4, 4, 4]] }\n"
     "measure = 'plate_force'\nalong = 'cells'\norder_at_least = 1",
     Judgement::no_case, "2 of at least 3 cases along cells"},
    // Statuses
    {"where = { method = 'mss-nfd' }\nexpect = 'wrinkled'", Judgement::pass, ""},
    {"where = { method = 'mss-nfd' }\nexpect = ['inverted', 'wrinkled']", Judgement::pass,
     ""},
    {cf + "expect = 'wrinkled'", Judgement::falls_short, "status is ok"},
    {cf + "measure = 'status'", Judgement::pass, ""},
    {"where = { method = 'mss-nfd' }\nmeasure = 'plate_force'\nat_least = 0",
     Judgement::falls_short, "status is wrinkled (a free face zigzags)"},
    {"where = { method = 'mss-nfd' }\nmeasure = 'plate_force'\nat_least = 0\n"
     "expect = 'wrinkled'",
     Judgement::pass, ""},
    {"where = { method = 'fem' }\nexpect = 'ok'", Judgement::pass, ""},
    {"where = { method = ['mss-cf', 'mss-nfd'], nu = 0.25 }\nexpect = 'ok'",
     Judgement::no_case, "their status is ok or wrinkled"},
    // What is not there, or there several times
    {"where = { method = 'mss-cf', nu = 0.3 }\nmeasure = 'plate_force'\nat_least = 0",
     Judgement::no_case, "the others have nu = 0.1 or 0.25 or 0.4"},
    {"where = { method = 'fem' }\nmeasure = 'plate_force'\nat_least = 0",
     Judgement::no_case,
     "cases match method = 'fem'; they differ in cells (2,2,2 or 4,4,4 or 8,8,8)"},
    // Settings as scenes have them
    {"where = { method = 'mss-cf', nu = 0.25, deformation = '5%' }\n"
     "measure = 'plate_force'\nat_least = 0",
     Judgement::pass, ""}};

// Each of them with a value that was not computed.
const std::string null_case = "where = { method = 'mss-cf', nu = 0.4 }\n";
const std::vector<std::string> nulls{
    null_case + "measure = 'volume_error'\nequals = 0\nabsolute = 1e300",
    null_case + "measure = 'volume_error'\nat_most = 1",
    null_case + "measure = 'volume_error'\nagainst = { nu = 0.25 }\nabsolute = 1e300",
    cf + "measure = 'volume_error'\nagainst = { nu = 0.4 }\nabsolute = 1e300",
    cf + "measure = 'volume_error'\nratio_to = { nu = 0.4 }\nat_most = 1e300",
    "where = { method = 'mss-cf' }\nmeasure = 'volume_error'\nalong = 'nu'\n"
    "monotonic = 'decreasing'",
    cf + "measure = 'strain_energy'\nat_least = 0"};  // no case has it

struct BadInput {
  std::string text, message;
};
std::ostream& operator<<(std::ostream& out, const BadInput& bad) {
  return out << bad.text;
}

const std::vector<BadInput> bad_inputs{
    {"", "gates.toml:1:1: expected at least one [[gate]], got none"},
    {"gate = 3", "gates.toml:1:1: expected at least one [[gate]], got none"},
    {"[[gate]]\nname = ", "gates.toml:2:"},
    {"[[gates]]\n",
     "gates.toml:1:3: unknown key 'gates', did you mean 'gate'? expected one of where, "},
    {head + force + "at_mots = 1",
     "gates.toml:6:1: unknown key 'at_mots', did you mean 'at_most'? expected one of "
     "name, "},
    {"[[gate]]\nname = 'g'\n" + force + "at_most = 1",
     "gates.toml:1:1: reason: expected a text, got none"},
    {"[[gate]]\nreason = 'r'\n" + force + "at_most = 1",
     "gates.toml:1:1: name: expected a text, got none"},
    {head + "measure = 'plate_force'\nat_most = 1",
     "gates.toml:1:1: where: expected settings that select a case, got none"},
    {head + force, "gate: expected a measure with a band, or a status to expect, got"},
    {head + cf + "at_most = 1",
     "gates.toml:5:11: at_most: expected the name of a measure"},
    {head + force + "equals = 1",
     "gates.toml:6:10: equals: expected a width with it: absolute, relative or both, got "
     "none"},
    {head + force + "equals = 1\nabsolute = 0",
     "gates.toml:7:12: absolute: expected a positive finite number, got 0"},
    {head + force + "equals = 1\nrelative = -0.1", "expected a positive finite number"},
    {head + force + "equals = 0\nrelative = 0.1",
     "gates.toml:6:10: equals: expected an absolute width about 0, got a relative one"},
    {head + force + "equals = 'one'\nrelative = 0.1",
     "expected a finite number, got 'one'"},
    {head + force + "equals = 1\nabsolute = 1\nat_most = 2",
     "gates.toml:8:11: at_most: expected one kind of band, got equals and at_most"},
    {head + force + "at_most = 1\nabsolute = 1",
     "gates.toml:7:12: absolute: expected against or equals with it, got at_most"},
    {head + force + "at_least = 2\nat_most = 1",
     "gates.toml:7:11: at_most: expected more than at_least = 2, got 1"},
    {head + force + "ratio_to = { nu = 0.4 }",
     "gates.toml:6:12: ratio_to: expected at_least or at_most with it, got neither"},
    {head + force + "against = 'fem'\nrelative = 1", "expected a table of settings"},
    {head + force + "monotonic = 'up'\nalong = 'nu'",
     "gates.toml:6:13: monotonic: unknown value 'up', expected one of increasing, "
     "decreasing"},
    {head + force + "monotonic = 'increasing'",
     "gates.toml:1:1: along: expected a text, got none"},
    {head + force + "order_at_least = 1\nalong = 'nu'",
     "gates.toml:7:9: along: expected 'cells' for an order of convergence, got 'nu'"},
    {head + force + "order_between = [2, 1]\nalong = 'cells'",
     "expected two positive numbers, the smaller one first, got [2, 1]"},
    {head + cf + "expect = 'fine'", "gates.toml:5:10: expect"},
    {head + force + "at_most = 1\n" + head + force + "at_most = 1",
     "gates.toml:8:8: name: expected a name of its own, got 'g' again"},
    // Known when the results are
    {head + "where = { method = 'mss-cf', mu = 1 }\nexpect = 'ok'",
     "gates.toml:4:35: mu: unknown column 'mu', did you mean 'nu'? expected one of "
     "scene, "},
    {head + "where = { nu = 'soft' }\nexpect = 'ok'",
     "gates.toml:4:16: nu: expected a number, as cases have it, got 'soft'"},
    {head + "where = { nu = { low = 0 } }\nexpect = 'ok'",
     "gates.toml:4:16: nu: expected a number, text, truth value or list of them, got a "
     "table"},
    {head + "where = { cells = 4 }\nexpect = 'ok'",
     "gates.toml:4:19: cells: expected 3 numbers, or a list of such lists, got cells = "
     "4"},
    {head + cf + "measure = 'plate_froce'\nat_most = 1",
     "gates.toml:1:1: unknown measure 'plate_froce', did you mean 'plate_force'?"},
    {head + cf + "measure = 'force'\nat_most = 1",
     "gates.toml:1:1: measure: expected 'force.' and one of x, y, z, got 'force'"},
    {head + cf + "measure = 'plate_force.x'\nat_most = 1",
     "expected 'plate_force', which has no components, got 'plate_force.x'"}};

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

BOOST_DATA_TEST_CASE(a_gate_has_the_verdict_it_must, data::make(examples)) {
  const Outcome outcome = outcome_of(sample.gate);
  BOOST_TEST((outcome.verdict == sample.verdict), outcome.explanation);
  BOOST_TEST(outcome.explanation.find(sample.explanation) != std::string::npos,
             outcome.explanation);
  BOOST_TEST(outcome.explanation.empty() == (sample.verdict == Judgement::pass));
}

// What a gate asks agrees, whatever the cases were held against.
BOOST_DATA_TEST_CASE(a_second_reference_changes_no_verdict, data::make(examples)) {
  const Outcome outcome = outcome_of(sample.gate, beside_two_references());
  BOOST_TEST((outcome.verdict == sample.verdict), outcome.explanation);
  BOOST_TEST(outcome.explanation.find(sample.explanation) != std::string::npos,
             outcome.explanation);
}

BOOST_AUTO_TEST_CASE(deviations_from_two_references_are_told_apart_by_name) {
  const Columns cases = beside_two_references();
  const std::string deviation = "\nmeasure = 'deviation_max'\nat_most = 0.0015";
  const Outcome several =
      outcome_of("where = { method = 'mss-cf', nu = 0.25 }" + deviation, cases);
  BOOST_TEST((several.verdict == Judgement::no_case));
  BOOST_TEST(several.explanation ==
             "2 cases match method = 'mss-cf', nu = 0.25; they differ in reference "
             "(fem-hooke:q2 or fem-stvk:q2); their deviation_max is 0.001 or 0.002");
  const auto beside = [&](const std::string& reference) {
    return outcome_of("where = { method = 'mss-cf', nu = 0.25, reference = '" +
                          reference + "' }" + deviation,
                      cases)
        .verdict;
  };
  BOOST_TEST((beside("fem-hooke:q2") == Judgement::pass));
  BOOST_TEST((beside("fem-stvk:q2") == Judgement::falls_short));
  const Outcome sweep = outcome_of(
      "where = { method = 'mss-cf', nu = [0.1, 0.25] }\nmeasure = 'deviation_max'\n"
      "along = 'nu'\nmonotonic = 'increasing'",
      cases);
  BOOST_TEST((sweep.verdict == Judgement::no_case));
  BOOST_TEST(sweep.explanation.find("reference (fem-hooke:q2") != std::string::npos,
             sweep.explanation);
}

BOOST_DATA_TEST_CASE(a_null_measure_never_passes, data::make(nulls)) {
  const Outcome outcome = outcome_of(sample);
  BOOST_TEST((outcome.verdict == Judgement::falls_short));
  BOOST_TEST(outcome.explanation.find("is null") != std::string::npos,
             outcome.explanation);
}

BOOST_DATA_TEST_CASE(bad_gate_files_are_refused_with_their_place,
                     data::make(bad_inputs)) {
  std::string message;
  try {
    const auto all = parse_gates(sample.text, "gates.toml");
    check(all.front(), table(), "file.h5");
  } catch (const InputError& error) {
    message = error.what();
  }
  BOOST_TEST(message.find(sample.message) != std::string::npos, message);
}

// Half the band's half width from its upper edge; a quarter of the edge above it; a third
// of the whole change.
BOOST_AUTO_TEST_CASE(margins_are_relative_to_the_band,
                     *boost::unit_test::tolerance(1e-12)) {
  BOOST_TEST(outcome_of(force + "equals = 1.2\nabsolute = 0.2").margin.value() == 0.5);
  BOOST_TEST(outcome_of(force + "equals = 1.2\nabsolute = 0.05").margin.value() == -1.);
  BOOST_TEST(outcome_of(force + "at_least = 1.04").margin.value() == 0.25);
  BOOST_TEST(!outcome_of(force + "at_least = 0").margin.has_value());
  const Outcome sweep = outcome_of(
      "where = { method = 'mss-cf' }\nmeasure = 'plate_force'\nalong = 'nu'\n"
      "monotonic = 'increasing'");
  BOOST_TEST(sweep.margin.value() == 1. / 3);
  BOOST_TEST(sweep.values == (std::vector{1.2, 1.3, 1.5}),
             boost::test_tools::per_element());
}

// The file's own conditions hold for cases that have the setting, a gate's before them.
BOOST_AUTO_TEST_CASE(conditions_of_the_file_are_every_gate_s) {
  const std::string common = "where = { element = 'q2', nu = 0.1 }\n";
  const auto verdict = [&](const std::string& gate) {
    const auto all = parse_gates(common + head + gate, "gates.toml");
    return check(all.front(), table(), "file.h5").verdict;
  };
  BOOST_TEST((verdict("where.method = 'mss-cf'\nexpect = 'ok'") == Judgement::pass));
  BOOST_TEST((verdict(cf + "expect = 'ok'") == Judgement::pass));
  BOOST_TEST((verdict("where = " + fine + "expect = 'ok'") == Judgement::no_case));
}

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

BOOST_AUTO_TEST_CASE(shipped_gates_are_well_formed) {
  BOOST_TEST(shipped_gates().size() == 2U);
  for (const ShippedFile& file : shipped_gates())
    BOOST_TEST(parse_gates(file.text, std::string(file.name)).size() > 20U);
}

BOOST_AUTO_TEST_SUITE_END()
