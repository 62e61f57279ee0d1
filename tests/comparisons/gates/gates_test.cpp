#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <ostream>

#include "comparisons/gates/gate_check.hpp"
#include "comparisons/gates/gate_file.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/comparisons/gates/example_gates.hpp"

using namespace springcheck;
using namespace springcheck::gates;
namespace data = boost::unit_test::data;

BOOST_AUTO_TEST_SUITE(gates_test)

namespace {

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

struct Example {
  std::string gate;
  Judgement verdict;
  std::string explanation;  // a part of it
};
std::ostream& operator<<(std::ostream& out, const Example& example) {
  return out << example.gate;
}

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
     Judgement::no_case, "; the others have nu = 0.1 or 0.25 or 0.4"},
    {"where = { method = 'mss-cff', nu = 0.25 }\nmeasure = 'plate_force'\nat_least = 0",
     Judgement::no_case, "; did you mean 'mss-cf'? the others have method = "},
    {"where = { method = 'fem' }\nmeasure = 'plate_force'\nat_least = 0",
     Judgement::no_case,
     "cases match method = 'fem'; they differ in cells (2,2,2 or 4,4,4 or 8,8,8)"},
    // Settings as scenes have them
    {"where = { method = 'mss-cf', nu = 0.25, deformation = '5%' }\n"
     "measure = 'plate_force'\nat_least = 0",
     Judgement::pass, ""}};

// Each of them with a value that was not computed.
const std::vector<std::string> nulls{
    null_case + "measure = 'volume_error'\nequals = 0\nabsolute = 1e300",
    null_case + "measure = 'volume_error'\nat_most = 1",
    null_case + "measure = 'volume_error'\nagainst = { nu = 0.25 }\nabsolute = 1e300",
    cf + "measure = 'volume_error'\nagainst = { nu = 0.4 }\nabsolute = 1e300",
    cf + "measure = 'volume_error'\nratio_to = { nu = 0.4 }\nat_most = 1e300",
    "where = { method = 'mss-cf' }\nmeasure = 'volume_error'\nalong = 'nu'\n"
    "monotonic = 'decreasing'",
    cf + "measure = 'strain_energy'\nat_least = 0"};  // no case has it

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

BOOST_AUTO_TEST_CASE(cuts_are_found_however_they_are_written) {
  Columns cases = table();
  cases.texts["cut"] = std::vector<std::string>(7, "");
  cases.texts["cut"][1] = "split,name=cut,plane=0,0,1,0.025";
  const auto verdict_of = [&](const std::string& cut) {
    return outcome_of("where = { cut = '" + cut +
                          "' }\nmeasure = 'plate_force'\n"
                          "equals = 1.3\nrelative = 1e-3\n",
                      cases)
        .verdict;
  };
  BOOST_TEST((verdict_of("split, plane = 0, 0, 2, 5cm") == Judgement::pass));
  BOOST_TEST((verdict_of("split,plane=0,0,1,0.02") == Judgement::no_case));
  BOOST_CHECK_THROW(verdict_of("splitt,plane=0,0,1,0.02"), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
