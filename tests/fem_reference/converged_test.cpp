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

struct Limit {
  double value;
  double distance;  // of the finest grid's
};

Limit aitken(double coarse, double middle, double fine) {
  const double rate = (fine - middle) / (middle - coarse);  // per halving
  BOOST_TEST_MESSAGE("rate " << rate);
  BOOST_TEST(rate > 0.1);  // clamped edges are singular
  BOOST_TEST(rate < 0.5);
  const double rest = (fine - middle) * rate / (1 - rate);
  return {.value = fine + rest, .distance = std::abs(rest)};
}

/// The limits of both discretisations are five times nearer to each other than the
/// finest grid of q1 is to its own.
void expect_one_limit(Law law, const Vector3& strain, double angle,
                      const std::function<double(const Measured&)>& measure) {
  const auto limit = [&](Element element, int cells) {
    const auto on = [&](int n) {
      return measure(measured(
          cube_of(n), 0.25,
          {.law = law, .element = element, .linear_solver = LinearSolver::multigrid},
          strain, angle));
    };
    return aitken(on(cells), on(2 * cells), on(4 * cells));
  };
  const Limit linear = limit(Element::q1, 5);
  check(linear.value, limit(Element::q2, 3).value, linear.distance / 5);
}

double volume_error(const Measured& m) {
  return m.volume_error;
}
double force(const Measured& m) {
  return m.force.norm();
}
double torque(const Measured& m) {
  return m.torque;
}

constexpr Law laws[] = {Law::cauchy_born, Law::hencky};

}  // namespace

BOOST_AUTO_TEST_CASE(volume_errors_in_compression_converge_to_one_value) {
  for (const Law law : laws)
    for (const double strain : {0.05, 0.20})
      expect_one_limit(law, {0, 0, -strain}, 0, volume_error);
}

BOOST_AUTO_TEST_CASE(forces_and_torques_converge_to_one_value,
                     *boost::unit_test::label("slow")) {
  for (const Law law : laws) {
    expect_one_limit(law, {0.20, 0, 0}, 0, force);
    expect_one_limit(law, Vector3::Zero(), 45 * degree, torque);
  }
}

BOOST_AUTO_TEST_SUITE_END()
