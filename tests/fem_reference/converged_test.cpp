#include "tests/fem_reference/figures.hpp"

#include <boost/test/unit_test.hpp>

// Converged values of the Cauchy-Born continuum of mss-cf and of Hencky's law, nu = 1/4,
// by two discretisations: q1 on 5, 10 and 20 cells across, q2 on 3, 6 and 12, each by
// Aitken's extrapolation.

using namespace springcheck;
using namespace springcheck::fem_reference;
using statics::LinearSolver;

BOOST_AUTO_TEST_SUITE(converged_test)

namespace {

double aitken(double coarse, double middle, double fine, double least_rate) {
  const double rate = (fine - middle) / (middle - coarse);  // per halving
  BOOST_TEST_MESSAGE("rate " << rate);
  BOOST_TEST(rate > least_rate);
  BOOST_TEST(rate < 0.5);
  return fine + (fine - middle) * rate / (1 - rate);
}

/// Expects both discretisations to have the same limit but for `band`. Clamped edges are
/// singular: the rate of q1 is not a quarter, and that of q2, whose coarsest grid has
/// three cells, is not yet the same.
void expect_one_limit(Law law, const Vector3& strain, double angle, double band,
                      const std::function<double(const Measured&)>& measure) {
  const auto limit = [&](Element element, int cells, double least_rate) {
    const auto on = [&](int n) {
      return measure(measured(cube_of(n), 0.25, {.law = law, .element = element}, strain,
                              angle, {.linear_solver = LinearSolver::multigrid}));
    };
    return aitken(on(cells), on(2 * cells), on(4 * cells), least_rate);
  };
  check(limit(Element::q1, 5, 0.3), limit(Element::q2, 3, 0.1), band);
}

double volume_error(const Measured& m) {
  return 100 * std::abs(m.volume_change);
}
double force(const Measured& m) {
  return m.force.norm();
}
double torque(const Measured& m) {
  return m.torque;
}

constexpr Law laws[] = {Law::cauchy_born, Law::hencky};

}  // namespace

// The bands are .02 points of volume at 20 %, and a tenth of it at 5 %.
BOOST_AUTO_TEST_CASE(volume_errors_in_compression_converge_to_one_value) {
  for (const Law law : laws) {
    expect_one_limit(law, {0, 0, -0.05}, 0, 0.002, volume_error);
    expect_one_limit(law, {0, 0, -0.20}, 0, 0.02, volume_error);
  }
}

// The bands are .05 % of the force and, for Hencky's torque, whose two limits are .055 %
// apart, .1 %.
BOOST_AUTO_TEST_CASE(forces_and_torques_converge_to_one_value,
                     *boost::unit_test::label("slow")) {
  for (const Law law : laws) expect_one_limit(law, {0.20, 0, 0}, 0, 0.0007, force);
  const Vector3 none = Vector3::Zero();
  expect_one_limit(Law::cauchy_born, none, 45 * degree, 30e-6, torque);
  expect_one_limit(Law::hencky, none, 45 * degree, 56e-6, torque);
}

BOOST_AUTO_TEST_SUITE_END()
