#include "meshing/basics/logarithm.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(logarithm_test)

// -x^2/2 + x^3/3 - ..., of which the next term is below the last digit.
BOOST_AUTO_TEST_CASE(small_arguments_keep_their_digits) {
  for (const double x : {1e-5, -1e-5, 1e-9})
    BOOST_TEST(log1p_minus(x) == -x * x / 2 + x * x * x / 3 - x * x * x * x / 4,
               boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(its_range_has_ends) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double x : {-1., -2., -infinity, infinity})
    BOOST_TEST(log1p_minus(x) == -infinity);
  BOOST_TEST(std::isnan(log1p_minus(std::nan(""))));
  BOOST_TEST(std::isfinite(log1p_minus(-1 + 1e-15)));
  BOOST_TEST(std::isfinite(log1p_minus(1e300)));
}

BOOST_AUTO_TEST_SUITE_END()
