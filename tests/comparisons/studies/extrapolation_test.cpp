#include <boost/test/unit_test.hpp>
#include <cmath>

#include "comparisons/studies/checked_number.hpp"
#include "comparisons/studies/extrapolation.hpp"

using namespace springcheck;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_SUITE(extrapolation_test)

namespace {

constexpr double noise = 1e-12;

Eigen::MatrixXd scalar(double value) {
  return Eigen::MatrixXd::Constant(1, 1, value);
}

Extrapolated limit_of(const GridSizes& sizes, double q1, double q2, double q3,
                      double formal_order = 2) {
  return extrapolate(sizes, {scalar(q1), scalar(q2), scalar(q3)}, noise, formal_order);
}

}  // namespace

// q = 2 + 3 h^p is its own extrapolation: exact up to round-off, amplified where the
// changes are small beside q.
BOOST_AUTO_TEST_CASE(a_power_law_is_recovered_for_constant_and_changing_ratios,
                     *boost::unit_test::tolerance(1e-9)) {
  for (const GridSizes& h :
       {GridSizes{0.4, 0.2, 0.1}, GridSizes{0.2, 0.1, 0.05}, GridSizes{0.5, 0.3, 0.2},
        GridSizes{1. / 3, 1. / 5, 1. / 10}})
    for (const double p : {0.5, 1., 1.4, 2., 3.}) {
      const auto q = [&](double size) { return 2 + 3 * std::pow(size, p); };
      const double error = 3 * std::pow(h[2], p);
      const Extrapolated limit = limit_of(h, q(h[0]), q(h[1]), q(h[2]), p);
      BOOST_TEST_REQUIRE(limit.order.has_value());
      BOOST_TEST(*limit.order == p);
      BOOST_TEST(limit.value(0) == 2.);
      BOOST_TEST(limit.error_bound(0) == 2.25 * error);
      // Below the formal order the observed one is taken, with a larger safety factor.
      const Extrapolated slow = limit_of(h, q(h[0]), q(h[1]), q(h[2]), 1.3 * p);
      BOOST_TEST(slow.value(0) == 2.);
      BOOST_TEST(slow.error_bound(0) == 4 * error);
    }
}

// p = ln((q1 - q2)/(q2 - q3))/ln 2 by hand: changes of 4 and 1 are of order 2, and a
// third of the last change is left. The index of the source, 1.25/3, is about the finest
// value 10, and the error bound about the limit holds it.
BOOST_AUTO_TEST_CASE(halving_follows_the_textbook_formula,
                     *boost::unit_test::tolerance(1e-12)) {
  const Extrapolated limit = limit_of({4, 2, 1}, 15, 11, 10);
  BOOST_TEST(*limit.order == 2.);
  BOOST_TEST(limit.value(0) == 10 - 1. / 3);
  BOOST_TEST(limit.index.value() == 1.25 / 3);
  BOOST_TEST(limit.error_bound(0) == 1.25 / 3 + 1. / 3);
}

// Changes of 4 and 1 again. By a formal order of 1 all of the last change is left: order
// 2 is not believed. Within a tenth, of 2.2 and 1.9, the formal one is, beyond, the
// smaller of both.
BOOST_AUTO_TEST_CASE(no_order_above_the_formal_one_is_believed,
                     *boost::unit_test::tolerance(1e-12)) {
  const auto expect = [](double formal, double order, double factor) {
    const double left = 1 / (std::pow(2, order) - 1);
    const Extrapolated limit = limit_of({4, 2, 1}, 15, 11, 10, formal);
    BOOST_TEST_CONTEXT(formal) {
      BOOST_TEST(*limit.order == 2.);
      BOOST_TEST(limit.value(0) == 10 - left);
      BOOST_TEST(limit.error_bound(0) == (factor + 1) * left);
    }
  };
  expect(1, 1, 3);
  expect(1.8, 1.8, 3);
  expect(1.9, 1.9, 1.25);
  expect(2.2, 2.2, 1.25);
  expect(2.3, 2, 3);
}

// An order of .4 is taken for 1/2; changes that fall a million times as if by the formal
// order; the limit goes beyond the finest value in both.
BOOST_AUTO_TEST_CASE(orders_out_of_range_are_replaced,
                     *boost::unit_test::tolerance(1e-9)) {
  const double change = std::pow(2, -0.4);
  const Extrapolated slow = limit_of({4, 2, 1}, 11, 10, 10 - change);
  const double left = change / (std::sqrt(2.) - 1);
  BOOST_TEST(*slow.order == 0.4);
  BOOST_TEST(slow.value(0) == 10 - change - left);
  BOOST_TEST(slow.error_bound(0) == 4 * left);
  // An order of .1, which does not count as observed, is taken for 1/2 too.
  const double slower = std::pow(2, -0.1);
  const Extrapolated crawls = limit_of({4, 2, 1}, 11, 10, 10 - slower);
  BOOST_TEST(!crawls.order.has_value());
  BOOST_TEST(crawls.error_bound(0) == 4 * slower / (std::sqrt(2.) - 1));
  const Extrapolated fast = limit_of({4, 2, 1}, 10, 11, 11.000001, 1);
  BOOST_TEST(!fast.order.has_value());
  BOOST_TEST(fast.value(0) == 11.000002);
  BOOST_TEST(fast.error_bound(0) == 4e-6);
}

BOOST_AUTO_TEST_CASE(what_grows_or_turns_back_is_not_extrapolated,
                     *boost::unit_test::tolerance(1e-12)) {
  const GridSizes halving{4, 2, 1};
  const auto expect_no_order = [&](double q1, double q2, double q3) {
    const Extrapolated limit = limit_of(halving, q1, q2, q3);
    BOOST_TEST(!limit.order.has_value());
    BOOST_TEST(limit.value(0) == q3);
    BOOST_TEST(limit.error_bound(0) == 3 * std::abs(q3 - q2) / (std::sqrt(2.) - 1));
  };
  expect_no_order(10, 11, 10.5);  // oscillates
  expect_no_order(10, 11, 12);    // order 0
  expect_no_order(10, 11, 13);    // grows
  expect_no_order(10, 10, 11);    // the first change is nothing
}

BOOST_AUTO_TEST_CASE(equal_values_have_converged_up_to_the_noise) {
  for (const double left_over : {0., 0.4 * noise}) {
    const Extrapolated limit = limit_of({4, 2, 1}, 5 + left_over, 5, 5 - left_over);
    BOOST_TEST(!limit.order.has_value());
    BOOST_TEST(limit.value(0) == 5 - left_over);
    BOOST_TEST(limit.error_bound(0) == noise);
  }
}

// The last change is nothing, an earlier one was not: no order, and no error bound below
// noise.
BOOST_AUTO_TEST_CASE(no_bar_is_smaller_than_the_noise) {
  const Extrapolated limit = limit_of({4, 2, 1}, 6, 5, 5);
  BOOST_TEST(!limit.order.has_value());
  BOOST_TEST(limit.error_bound(0) == noise);
}

// One order for the field, from its norms: the entry that does not change stays, the
// others follow. u = (1 + h, 2 - 2 h, 3).
BOOST_AUTO_TEST_CASE(a_field_is_extrapolated_with_one_order,
                     *boost::unit_test::tolerance(1e-12)) {
  const auto field = [](double h) {
    return Eigen::MatrixXd(Eigen::RowVector3d(1 + h, 2 - 2 * h, 3));
  };
  const Extrapolated limit =
      extrapolate({0.4, 0.2, 0.1}, {field(0.4), field(0.2), field(0.1)}, noise, 1);
  BOOST_TEST(*limit.order == 1.);
  BOOST_TEST((limit.value - Eigen::RowVector3d(1, 2, 3)).norm() < 1e-12);
  BOOST_TEST((limit.error_bound - Eigen::RowVector3d(0.225, 0.45, noise)).norm() < 1e-12);
}

// Changes of falling size that turn back are no convergence.
BOOST_AUTO_TEST_CASE(a_field_whose_changes_oppose_has_no_order) {
  const auto field = [](double x, double y) {
    return Eigen::MatrixXd(Eigen::RowVector2d(x, y));
  };
  const Extrapolated limit =
      extrapolate({4, 2, 1}, {field(0, 0), field(4, 4), field(2, 2)}, noise, 2);
  BOOST_TEST(!limit.order.has_value());
  BOOST_TEST(limit.value(0) == 2);
  BOOST_TEST(limit.error_bound(0) == 6 / (std::sqrt(2.) - 1), tolerance(1e-12));
}

// 10 +- 1 and 10.5 +- .2: the narrower, with an error bound that holds the other's limit.
BOOST_AUTO_TEST_CASE(the_better_known_of_two_limits_is_taken,
                     *boost::unit_test::tolerance(1e-12)) {
  const ConvergedNumber wide{.value = 10, .order = 1.2, .error_bound = 1},
      narrow{.value = 10.5, .order = 1.5, .error_bound = 0.2};
  for (const bool is_of_check : {true, false}) {
    const CheckedNumber known =
        is_of_check ? checked_number(wide, narrow) : checked_number(narrow, wide);
    BOOST_TEST(known.value == 10.5);
    BOOST_TEST(known.order.value() == 1.5);
    BOOST_TEST(known.error_bound == 0.5);
    BOOST_TEST(known.disagreement.value() == 0.5);
    BOOST_TEST(known.is_of_check == is_of_check);
    BOOST_TEST(known.is_resolved);
  }
  BOOST_TEST(checked_number({.value = 10.4, .order = {}, .error_bound = 1}, narrow)
                 .error_bound == 0.2);
}

BOOST_AUTO_TEST_CASE(limits_that_contradict_each_other_hold_both_intervals,
                     *boost::unit_test::tolerance(1e-12)) {
  const ConvergedNumber one{.value = 10, .order = {}, .error_bound = 0.5},
      other{.value = 11, .order = {}, .error_bound = 0.2};
  const CheckedNumber known = checked_number(one, other);
  BOOST_TEST(!known.is_resolved);
  BOOST_TEST(known.value == 11);
  BOOST_TEST(known.error_bound == 1.5);  // down to 9.5, where the other's ends
}

// The errors are C h^1.5 exactly, so that the tolerance is round-off. An error of zero
// has no logarithm.
BOOST_AUTO_TEST_CASE(fitted_order_is_the_exponent_of_a_power_law,
                     *boost::unit_test::tolerance(1e-12)) {
  const std::vector<double> sizes{0.5, 0.25, 0.1};
  std::vector<double> errors;
  for (const double h : sizes) errors.push_back(7 * std::pow(h, 1.5));
  BOOST_TEST(fitted_order(sizes, errors).value() == 1.5);
  errors.back() = 0;
  BOOST_TEST(!fitted_order(sizes, errors).has_value());
}

// The least squares of (0, 0), (1, 0), (2, 3) in logarithms have the slope 3/2 by hand.
BOOST_AUTO_TEST_CASE(fitted_order_is_the_least_squares_slope,
                     *boost::unit_test::tolerance(1e-12)) {
  const double e = std::exp(1.);
  const std::vector<double> sizes{1, e, e * e}, errors{1, 1, e * e * e};
  BOOST_TEST(fitted_order(sizes, errors).value() == 1.5);
}

BOOST_AUTO_TEST_SUITE_END()
