#include "comparisons/measures/measure_list.hpp"

#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

#include "comparisons/measures/measures.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(measure_list_test)

BOOST_AUTO_TEST_CASE(every_measure_is_described_in_the_order_of_reports) {
  std::vector<std::string> described, measured;
  for (const Described& measure : measure_list()) {
    described.emplace_back(measure.name);
    BOOST_TEST(!measure.description.empty());
  }
  const Measures none;
  for_each_measure(none,
                   [&](const char* name, const auto&) { measured.emplace_back(name); });
  BOOST_TEST(described == measured, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
