#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "comparisons/methods/methods.hpp"
#include "comparisons/studies/converged_number.hpp"
#include "comparisons/studies/split.hpp"
#include "tests/comparisons/settings.hpp"

// What a difference of two numbers converges to is computed by hand at nu = 0, where the
// formal order of q1-sri is 2. The tolerance is round-off.

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(converged_number_test, *boost::unit_test::tolerance(1e-12))

namespace {

constexpr double noise = 1e-8;

/// The grids of a cube of 4, 8 and 16 cells.
ThreeCases grids() {
  return plan_split(case_of("compression", {"method=mss-cf", "nu=0", "cells=4,4,4"}),
                    *find_method("fem-hencky"))
      .reference;
}

/// Changes from coarse to fine; the finest value is 10.
ConvergedNumber by_changes(double coarse, double fine) {
  return converged_difference(grids(), {10 + coarse + fine, 10 + fine, 10}, noise);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_formal_order_does_not_narrow_a_bound) {
  const ConvergedNumber limit = by_changes(4, 1);
  BOOST_TEST(limit.value == 10 - 1. / 3);
  BOOST_TEST(limit.order.value() == 2.);
  BOOST_TEST(limit.error_bound == 4. / 3);
}

// Orders of 1.85 and 2.15, within 10 % of the formal one, by which the last change leaves
// a third and the one before it a twelfth.
BOOST_AUTO_TEST_CASE(the_larger_of_two_rests_counts) {
  BOOST_TEST(by_changes(std::pow(2, 1.85), 1).error_bound == 4. / 3);
  BOOST_TEST(by_changes(std::pow(2, 2.15), 1).error_bound == 4 * std::pow(2, 2.15) / 12);
}

BOOST_AUTO_TEST_CASE(another_order_is_believed_in_both_rests) {
  const ConvergedNumber limit = by_changes(2, 1);
  BOOST_TEST(limit.value == 9.);
  BOOST_TEST(limit.error_bound == 4.);
}

BOOST_AUTO_TEST_CASE(a_small_last_change_is_no_convergence) {
  const ConvergedNumber limit = by_changes(64, 1);
  BOOST_TEST(limit.value == 10 - 1. / 3);
  BOOST_TEST(!limit.order.has_value());
  BOOST_TEST(limit.error_bound == 4 * 64. / 12);
  for (const double coarse : {1., -1.}) {
    BOOST_TEST(by_changes(coarse, 0).value == 10.);
    BOOST_TEST(by_changes(coarse, 0).error_bound == 4. / 12);
  }
}

// The rest is that of the order 1/2, for which (h2/h3)^p - 1 = sqrt(2) - 1.
BOOST_AUTO_TEST_CASE(changes_that_turn_back_or_grow_leave_the_finest_value) {
  const double rest = 1 / (std::sqrt(2.) - 1);
  const ConvergedNumber back = by_changes(1, -0.01);
  BOOST_TEST(back.value == 10.);
  BOOST_TEST(back.error_bound == 3 * rest / std::sqrt(2.));
  const ConvergedNumber growing = by_changes(1, 2);
  BOOST_TEST(growing.value == 10.);
  BOOST_TEST(growing.error_bound == 3 * 2 * rest);
}

// q2 on 3, 5 and 10 cells, whose formal order is that of the glued edges, 2: ratios of
// sizes of 5/3 and 2.
BOOST_AUTO_TEST_CASE(ratios_of_sizes_may_differ) {
  const ThreeCases grids =
      plan_split(case_of("compression", {"method=mss-cf", "nu=0", "cells=5,5,5"}),
                 *find_method("fem-hencky"))
          .reference_check;
  const ConvergedNumber exact =
      converged_difference(grids, {1. / 3, 1. / 5, 1. / 10}, noise);
  BOOST_TEST(exact.order.value() == 1.);
  BOOST_TEST(1 + exact.value == 1.);
  BOOST_TEST(exact.error_bound == 0.4);
  const ConvergedNumber falling = converged_difference(grids, {1 + 1e-3, 1e-3, 0}, noise);
  BOOST_TEST(falling.error_bound == 4 / (std::pow(5. / 3, 2) - 1) / 4);
}

BOOST_AUTO_TEST_CASE(changes_of_solvers_are_no_changes) {
  const ConvergedNumber limit = by_changes(noise / 2, -noise / 2);
  BOOST_TEST(limit.value == 10.);
  BOOST_TEST(!limit.order.has_value());
  BOOST_TEST(limit.error_bound == noise);
}

BOOST_AUTO_TEST_SUITE_END()
