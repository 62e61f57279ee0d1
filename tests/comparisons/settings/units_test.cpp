#include "comparisons/settings/units.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "comparisons/settings/given.hpp"
#include "meshing/basics/input_error.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(units_test)

namespace {

double read(const std::string& text, Dimension dimension) {
  return Given::from_text("--x", text).in(dimension);
}

std::string refusal(const std::string& text, Dimension dimension) {
  try {
    read(text, dimension);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

// Exactly: the double nearest to what is written. 57 deg was worked out to 60 digits.
BOOST_AUTO_TEST_CASE(numbers_with_a_unit_are_the_nearest_doubles) {
  using enum Dimension;
  for (int i = 1; i <= 1000; ++i) {
    const std::string tenths = std::to_string(i / 10) + "." + std::to_string(i % 10);
    BOOST_TEST(read(tenths + "%", fraction) == std::stod(tenths + "e-2"));
  }
  BOOST_TEST(read("35%", fraction) == 0.35);
  BOOST_TEST(read("57deg", angle) == 0.99483767363676785);
  BOOST_TEST(read("0.57deg", angle) == 0.009948376736367679);
  BOOST_TEST(read("30deg", angle) == 0.52359877559829893);
  BOOST_TEST(read("10kPa", pressure) == 10e3);
  BOOST_TEST(read("1.1e-3MPa", pressure) == 1.1e3);
  BOOST_TEST(read("0.7N/mm^2", pressure) == 0.7e6);
  BOOST_TEST(read("5cm", length) == 0.05);
  BOOST_TEST(read("1g/cm^3", density) == 1000);
  BOOST_TEST(read("20ms", Dimension::time) == 0.02);
  BOOST_TEST(read("20 ms", Dimension::time) == 0.02);
  BOOST_TEST(read("-981cm/s^2", acceleration) == -9.81);
  BOOST_TEST(read("3N/mm", stiffness) == 3000);
  BOOST_TEST(read("2%/s", rate) == 0.02);
  BOOST_TEST(read("0.3", pressure) == 0.3);
}

BOOST_AUTO_TEST_CASE(units_of_another_kind_are_refused_with_those_that_fit) {
  using enum Dimension;
  BOOST_TEST(refusal("10kg", pressure) ==
             "--x: expected a finite number, plain or in Pa, kPa, MPa, GPa, N/m^2, "
             "N/cm^2, N/mm^2, as in '5N/mm^2', got '10kg'");
  for (const char* text :
       {"5deg", "1e400%", "0e2147483647%", "nan", "inf%", "%", "5%%", ""})
    BOOST_TEST(refusal(text, fraction).starts_with("--x: expected a finite number"),
               text);
  BOOST_TEST(refusal("5%", angle).find("as in '45deg'") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(lists_are_converted_one_by_one) {
  const Given size = Given::from_text("--size", "5cm,50mm,0.05");
  const std::array<double, 3> expected{0.05, 0.05, 0.05};
  BOOST_TEST(size.in_si_units(Dimension::length).numbers<3>() == expected,
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
