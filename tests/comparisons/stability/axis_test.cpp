#include "comparisons/stability/axis.hpp"

#include <boost/test/unit_test.hpp>
#include <numbers>

#include "meshing/basics/input_error.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(axis_test)

namespace {

using Values = std::vector<std::string>;

bool names_the_place(const InputError& error) {
  return std::string(error.what()).find("--over") != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_range_has_equal_steps_and_both_ends) {
  const Axis axis = axis_named("--over", "nu=0:0.45:4");
  BOOST_TEST(axis.key == "nu");
  BOOST_TEST((axis.values == Values{"0", "0.15", "0.3", "0.45"}));
  BOOST_TEST(axis.is_range);
}

BOOST_AUTO_TEST_CASE(a_logarithmic_range_has_equal_factors) {
  const Axis axis = axis_named("--over", "density=0.001:1:log:10");
  BOOST_TEST_REQUIRE(axis.values.size() == 10U);
  BOOST_TEST(axis.values.front() == "0.001");
  BOOST_TEST(axis.values[1] == "0.00215443469003");  // 10^(1/3)
  BOOST_TEST(axis.values[3] == "0.01");
  BOOST_TEST(axis.values.back() == "1");
  BOOST_TEST(axis.is_range);
  BOOST_TEST((axis_named("--over", "young=1kPa:100kPa:log:3").values ==
              Values{"1kPa", "10kPa", "100kPa"}));
}

BOOST_AUTO_TEST_CASE(units_stay_with_their_numbers) {
  BOOST_TEST((axis_named("--over", "deformation=5%:20%:4").values ==
              Values{"5%", "10%", "15%", "20%"}));
  BOOST_TEST((axis_named("--over", "deformation=45deg:90deg:2").values ==
              Values{"45deg", "90deg"}));
  BOOST_TEST(middle("10%", "15%") == "12.5%");
  BOOST_TEST(number_of("12.5%") == 12.5);
  BOOST_TEST(units_per_one(unit_of("12.5%")) == 100);
  BOOST_TEST(units_per_one(unit_of("2deg")) == 180 / std::numbers::pi);
  BOOST_TEST(units_per_one(unit_of("2")) == 1);
}

BOOST_AUTO_TEST_CASE(only_ascending_numbers_have_values_between_them) {
  BOOST_TEST(axis_named("--over", "nu=0,0.25,0.4").is_range);
  BOOST_TEST(!axis_named("--over", "nu=0.25,0,0.4").is_range);
  BOOST_TEST(!axis_named("--over", "nu=0.25").is_range);
  BOOST_TEST(!axis_named("--over", "deformation=5%,10deg").is_range);
  BOOST_TEST(axis_named("--over", "young=5kPa:10kPa:3").is_range);
  BOOST_TEST(!axis_named("--over", "mesh=1.msh,2.msh").is_range);
  BOOST_TEST(!axis_named("--over", "traction=1,0,0;2,0,0").is_range);
  BOOST_TEST(!axis_named("--over", "cell-type=hexahedron,tetrahedron").is_range);
  const Axis grids = axis_named("--over", "cells=4,4,4;6,6,6");
  BOOST_TEST((grids.values == Values{"4,4,4", "6,6,6"}));
  BOOST_TEST(!grids.is_range);
}

BOOST_AUTO_TEST_CASE(units_that_begin_with_a_digit_stay_apart) {
  BOOST_TEST((axis_named("--over", "rate=1 1/s:3 1/s:3").values ==
              Values{"1 1/s", "2 1/s", "3 1/s"}));
}

BOOST_AUTO_TEST_CASE(what_is_no_axis_is_refused) {
  for (const char* text :
       {"nu", "nu=", "nu=0:1", "nu=1:0:3", "nu=0:1:1", "nu=0:1:1001", "nu=0:1:2.5",
        "nu=0:1:log:3", "young=1:10:log", "young=1:10:lin:3", "nu=0:x:3", "nu=0%:1:3",
        "nu=0:inf:3", "nu=0,,1", "mu=0:1:3", "method=mss-cf,mss-nfd", "=0:1:3", ""})
    BOOST_CHECK_EXCEPTION(axis_named("--over", text), InputError, names_the_place);
}

BOOST_AUTO_TEST_SUITE_END()
