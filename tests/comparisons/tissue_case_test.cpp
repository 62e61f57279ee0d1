#define BOOST_TEST_MODULE tissue_case
#include "comparisons/tissue/tissue_case.hpp"

#include <boost/test/unit_test.hpp>

using namespace springcheck;

BOOST_AUTO_TEST_CASE(what_leaves_the_fitted_range_is_called_an_extrapolation) {
  const tissue::FitRange range;
  const dynamics::LoadPath within{{.time = 1 / 0.133, .fraction = 1}};
  BOOST_TEST(extrapolation(range, within, 1).empty());
  BOOST_TEST(extrapolation(range, within, 1.5) ==
             "extrapolated beyond the fitted range: shear strains of 1.5 (fitted to 1)");
  const std::string fast = extrapolation(range, {{.time = 0.5, .fraction = 1}}, 0.5);
  BOOST_TEST(fast.ends_with("rates of 1 1/s (fitted from 0.0151 to 0.67)"), fast);
  BOOST_TEST(!extrapolation(range, {{.time = 1000, .fraction = 1}}, 0.5).empty());
  // Small strains are linear; their range is that of the frequencies.
  BOOST_TEST(extrapolation(range, {{.time = 1e-3, .fraction = 1}}, 0.005).empty());
  // A hold has no rate.
  BOOST_TEST(extrapolation(
                 range, {{.time = 1, .fraction = 1}, {.time = 1e3, .fraction = 1}}, 0.5)
                 .empty());
}
