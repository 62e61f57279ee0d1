#include "tests/fem_reference/figures.hpp"

#include <boost/test/unit_test.hpp>

// Converged values of the Cauchy-Born continuum of mss-cf and of Hencky's law, nu = 1/4,
// against those of an independent program: Aitken extrapolation of q1 on 10, 20 and 40
// cells across there, on 5, 10 and 20 here.

using namespace springcheck;
using namespace springcheck::fem_reference;
using statics::LinearSolver;

BOOST_AUTO_TEST_SUITE(converged_test)

namespace {

struct Extrapolated {
  double value;
  double rate;  // of the differences, per halving
};

Extrapolated aitken(double coarse, double middle, double fine) {
  const double rate = (fine - middle) / (middle - coarse);
  return {.value = fine + (fine - middle) * rate / (1 - rate), .rate = rate};
}

Extrapolated converged(Law law, const Vector3& strain, double angle,
                       const std::function<double(const Measured&)>& measure) {
  const auto on = [&](int cells) {
    return measure(measured(
        cube_of(cells), 0.25,
        {.law = law, .element = Element::q1, .linear_solver = LinearSolver::multigrid},
        strain, angle));
  };
  const double coarse = on(5), middle = on(10);
  const Extrapolated limit = aitken(coarse, middle, on(20));
  BOOST_TEST_MESSAGE(limit.value << ", rate " << limit.rate);
  BOOST_TEST(limit.rate > 0.3);  // clamped edges are singular
  BOOST_TEST(limit.rate < 0.5);
  return limit;
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

constexpr Law spring_law = Law::cauchy_born;

}  // namespace

// Bands: the difference between the two triples of grids, .02 points of volume.
BOOST_AUTO_TEST_CASE(volume_errors_in_compression_converge_to_the_stored_values) {
  const Vector3 five(0, 0, -0.05), twenty(0, 0, -0.20);
  check(converged(spring_law, five, 0, volume_error).value, 3.098, 0.002);
  check(converged(Law::hencky, five, 0, volume_error).value, 3.060, 0.002);
  check(converged(spring_law, twenty, 0, volume_error).value, 13.203, 0.02);
  check(converged(Law::hencky, twenty, 0, volume_error).value, 12.490, 0.02);
}

// Bands: .05 % of the force.
BOOST_AUTO_TEST_CASE(forces_and_torques_converge_to_the_stored_values,
                     *boost::unit_test::label("slow")) {
  const Vector3 sideways(0.20, 0, 0), none = Vector3::Zero();
  check(converged(spring_law, sideways, 0, force).value, 1.4336, 0.0007);
  check(converged(Law::hencky, sideways, 0, force).value, 1.2994, 0.0007);
  check(converged(spring_law, none, 45 * degree, torque).value, 58368e-6, 30e-6);
}

BOOST_AUTO_TEST_SUITE_END()
