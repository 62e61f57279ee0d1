#include "comparisons/gates/gate_file.hpp"

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <ostream>

#include "comparisons/gates/gate_check.hpp"
#include "comparisons/shipped/shipped.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/comparisons/gates/example_gates.hpp"

using namespace springcheck;
using namespace springcheck::gates;
namespace data = boost::unit_test::data;

BOOST_AUTO_TEST_SUITE(gate_file_test)

namespace {

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

}  // namespace

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

BOOST_AUTO_TEST_CASE(shipped_gates_are_well_formed) {
  BOOST_TEST(shipped_gates().size() == 2U);
  for (const ShippedFile& file : shipped_gates())
    BOOST_TEST(parse_gates(file.text, std::string(file.name)).size() > 20U);
}

BOOST_AUTO_TEST_SUITE_END()
