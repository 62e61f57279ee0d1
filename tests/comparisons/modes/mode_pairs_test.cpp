#include <boost/test/unit_test.hpp>

#include <cmath>

#include "comparisons/modes/mode_pairs.hpp"

using namespace springcheck;
namespace utf = boost::unit_test;

BOOST_AUTO_TEST_SUITE(mode_pairs_test)

namespace {

NaturalModes modes(const Eigen::VectorXd& frequencies, const Eigen::MatrixXd& shapes) {
  return {.zero_modes = 0, .frequencies = frequencies, .shapes = shapes};
}

}  // namespace

BOOST_AUTO_TEST_CASE(equal_frequencies_make_a_multiplet) {
  Eigen::VectorXd f(5);
  f << 1, 2, 2 + 1e-9, 2.1, 3;
  const auto groups = multiplets(modes(f, Eigen::MatrixXd::Identity(5, 5)));
  BOOST_TEST_REQUIRE(groups.size() == 4U);
  BOOST_TEST(groups[1].first == 1);
  BOOST_TEST(groups[1].count == 2);
  BOOST_TEST(groups[2].first == 3);
}

// Shapes in another order, of other lengths, a pair turned among itself, and the last one
// 30 degrees off: cos^2 = 3/4. Round-off.
BOOST_AUTO_TEST_CASE(counterparts_are_found_by_shape, *utf::tolerance(1e-12)) {
  Eigen::MatrixXd shapes = Eigen::MatrixXd::Identity(6, 4);
  const NaturalModes own = modes(Eigen::Vector4d(1, 2, 2, 5), shapes);
  Eigen::MatrixXd turned = Eigen::MatrixXd::Zero(6, 5);
  turned.col(0) = 7 * (std::sqrt(0.75) * Eigen::VectorXd::Unit(6, 3) +
                       0.5 * Eigen::VectorXd::Unit(6, 4));
  turned.col(1) = Eigen::VectorXd::Unit(6, 1) + Eigen::VectorXd::Unit(6, 2);
  turned.col(2) = Eigen::VectorXd::Unit(6, 5);
  turned.col(3) = Eigen::VectorXd::Unit(6, 1) - Eigen::VectorXd::Unit(6, 2);
  turned.col(4) = Eigen::VectorXd::Unit(6, 0);
  Eigen::VectorXd f(5);
  f << 0.5, 3, 3.5, 4, 6;
  const auto found = counterparts(own, multiplets(own), modes(f, turned));
  BOOST_TEST_REQUIRE(found.size() == 3U);
  BOOST_TEST(found[0].frequency == 6.);
  BOOST_TEST(found[0].mac == 1.);
  BOOST_TEST(found[1].frequency == (3. + 4) / 2);
  BOOST_TEST(found[1].mac == 1.);
  BOOST_TEST(found[2].frequency == 0.5);
  BOOST_TEST(found[2].mac == 0.75);
}

// One of the others' pair, by accident of equal frequency with a foreign mode, is as good
// a counterpart; the space of one is not used twice.
BOOST_AUTO_TEST_CASE(mixtures_are_sought_on_both_sides, *utf::tolerance(1e-12)) {
  const NaturalModes own = modes(Eigen::Vector2d(1, 2), Eigen::MatrixXd::Identity(4, 2));
  Eigen::MatrixXd mixed = Eigen::MatrixXd::Zero(4, 3);
  mixed.col(0) << 1, 0, 1, 0;
  mixed.col(1) << 1, 0, -1, 0;
  mixed.col(2) << 0.8, 0.6, 0, 0;
  const auto found =
      counterparts(own, multiplets(own), modes(Eigen::Vector3d(3, 3, 4), mixed));
  BOOST_TEST(found[0].frequency == 3.);
  BOOST_TEST(found[0].mac == 1.);
  BOOST_TEST(found[1].frequency == 4.);
  BOOST_TEST(found[1].mac == 0.36);
}

// Two modes look like the same one of the others: the first has it, the second the next.
BOOST_AUTO_TEST_CASE(a_mode_is_taken_once, *utf::tolerance(1e-12)) {
  Eigen::MatrixXd shapes(3, 2), others = Eigen::MatrixXd::Identity(3, 2);
  shapes << 1, 0.8, 0, 0.6, 0, 0;
  const NaturalModes own = modes(Eigen::Vector2d(1, 2), shapes);
  const auto found =
      counterparts(own, multiplets(own), modes(Eigen::Vector2d(3, 4), others));
  BOOST_TEST(found[0].frequency == 3.);
  BOOST_TEST(found[1].frequency == 4.);
  BOOST_TEST(found[1].mac == 0.36);
}

// 30 and 60 degrees off the plane of the modes: 3/4 and 1/4 belong to it. The third,
// wholly strange, swings faster than what is asked for.
BOOST_AUTO_TEST_CASE(strangers_lie_outside_the_modes_space) {
  const NaturalModes own = modes(Eigen::Vector2d(1, 2), Eigen::MatrixXd::Identity(4, 2));
  Eigen::MatrixXd others = Eigen::MatrixXd::Zero(4, 3);
  others.col(0) << std::sqrt(0.75), 0, 0.5, 0;
  others.col(1) << 0, 0.5, 0, std::sqrt(0.75);
  others.col(2) << 0, 0, 1, 0;
  const auto found = strangers(own, modes(Eigen::Vector3d(1, 1.5, 4), others), 2);
  BOOST_TEST_REQUIRE(found.size() == 1U);
  BOOST_TEST(found[0] == 1.5);
}

BOOST_AUTO_TEST_SUITE_END()
