#include "dynamics/integrators.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <limits>

using namespace springcheck::dynamics;

BOOST_AUTO_TEST_SUITE(integrators_test)

namespace {

using Complex = std::complex<double>;

constexpr double omega = 3;  // [rad/s]

/// x'' = -2 zeta omega x' - omega^2 x from x = 1 at rest.
struct Oscillator {
  double zeta;
  double x = 1, v = 0;

  void advance(Integrator integrator, double dt, bool is_first) {
    const double kick = integrator == Integrator::verlet && is_first ? dt / 2 : dt;
    step(integrator, x, v, -2 * zeta * omega * v - omega * omega * x, dt, kick);
  }
};

/// The largest |x| of the last tenth of `steps` over that of the first: above 1 by far
/// where the motion grows, and infinite where it has left all bounds.
double growth(Integrator integrator, double zeta, double dt, int steps) {
  Oscillator body{.zeta = zeta};
  double first = 0, last = 0;
  for (int n = 0; n < steps; ++n) {
    body.advance(integrator, dt, n == 0);
    if (!std::isfinite(body.x)) return std::numeric_limits<double>::infinity();
    if (n < steps / 10) first = std::max(first, std::abs(body.x));
    if (n >= steps - steps / 10) last = std::max(last, std::abs(body.x));
  }
  return last / first;
}

/// Error of x after one and a half periods without dashpots.
double error(Integrator integrator, int steps) {
  const double duration = 3 * M_PI / omega + 0.2;
  Oscillator body{.zeta = 0};
  for (int n = 0; n < steps; ++n) body.advance(integrator, duration / steps, n == 0);
  return std::abs(body.x - std::cos(omega * duration));
}

}  // namespace

// On x' = Gamma x explicit Euler multiplies by 1 + dt Gamma, which is of modulus 1 on the
// circle of radius 1/dt about -1/dt (Golec 2018, Eq. 2.32 and 2.33). The tolerance is
// round-off of a few products.
BOOST_AUTO_TEST_CASE(explicit_euler_multiplies_by_its_amplification_factor,
                     *boost::unit_test::tolerance(1e-13)) {
  constexpr double dt = 0.1;
  for (const Complex gamma : {Complex(-1, 0), Complex(-19, 0), Complex(-21, 0),
                              Complex(0, 5), Complex(-3, 4), Complex(-10, 10)}) {
    Complex x = 1, v = gamma;
    for (int n = 0; n < 10; ++n) {
      v = gamma * x;
      step(Integrator::explicit_euler, x, v, gamma * v, dt, dt);
    }
    const Complex expected = std::pow(1. + dt * gamma, 10);
    BOOST_TEST(x.real() == expected.real());
    BOOST_TEST(x.imag() == expected.imag());
    BOOST_TEST(std::abs(x) == std::pow(std::abs(1. + dt * gamma), 10));
  }
}

// x and v of the damped oscillator keep to the mode of Gamma = omega (-zeta + i sqrt(1 -
// zeta^2)): both are multiplied by 1 + dt Gamma, above 1 in modulus from dt = 2
// zeta/omega on.
BOOST_AUTO_TEST_CASE(explicit_euler_is_stable_up_to_twice_zeta_over_omega) {
  for (const double zeta : {0.05, 0.3, 0.9}) {
    const Complex gamma = omega * Complex(-zeta, std::sqrt(1 - zeta * zeta));
    const double limit = 2 * zeta / omega;
    Complex x = 1, v = gamma;
    step(Integrator::explicit_euler, x, v, -2 * zeta * omega * v - omega * omega * x,
         limit, limit);
    BOOST_TEST(std::abs(x) == 1, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(std::abs(v) == omega, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(growth(Integrator::explicit_euler, zeta, 0.99 * limit, 20000) < 0.5);
    BOOST_TEST(growth(Integrator::explicit_euler, zeta, 1.01 * limit, 20000) > 2);
  }
  BOOST_TEST(growth(Integrator::explicit_euler, 0, 1e-3, 200000) > 2);  // no step at all
}

// z = -1 solves (z-1)^2 + 2 zeta omega dt (z-1) + (omega dt)^2 z = 0 at dt omega = 2
// (sqrt(1 + zeta^2) - zeta); 2/omega without dashpots.
BOOST_AUTO_TEST_CASE(symplectic_steps_are_stable_up_to_the_limit_of_the_textbook) {
  for (const Integrator integrator :
       {Integrator::semi_implicit_euler, Integrator::verlet})
    for (const double zeta : {0., 0.05, 0.3, 1.}) {
      const double limit = 2 * (std::sqrt(1 + zeta * zeta) - zeta) / omega;
      BOOST_TEST(growth(integrator, zeta, 0.999 * limit, 20000) < 1.01);
      BOOST_TEST(growth(integrator, zeta, 1.001 * limit, 20000) > 1e10);
    }
}

// Halving dt halves the error of a scheme of first order and quarters that of second. The
// orders are limits: at these steps they are met to 1 %.
BOOST_AUTO_TEST_CASE(verlet_is_of_second_order_and_the_eulers_of_first) {
  const auto order = [](Integrator integrator, int steps) {
    return std::log2(error(integrator, steps) / error(integrator, 2 * steps));
  };
  BOOST_TEST(std::abs(order(Integrator::verlet, 1000) - 2) < 0.01);
  BOOST_TEST(std::abs(order(Integrator::semi_implicit_euler, 10000) - 1) < 0.01);
  BOOST_TEST(std::abs(order(Integrator::explicit_euler, 100000) - 1) < 0.01);
}

// x_n+1 = 2 x_n - x_n-1 + dt^2 a_n (Golec 2018, Eq. 2.20), begun by Taylor's series, for
// an acceleration that is not linear. The round-off of 1000 steps adds up in both.
BOOST_AUTO_TEST_CASE(verlet_s_positions_are_stoermer_s) {
  constexpr double dt = 0.05, start = 1.2, speed = -0.4;
  const auto acceleration = [](double x) { return -x * x * x - std::sin(x); };
  double before = start, here = start + dt * speed + dt * dt / 2 * acceleration(start);
  double x = start, v = speed, largest = 0;
  for (int n = 0; n < 1000; ++n) {
    step(Integrator::verlet, x, v, acceleration(x), dt, n == 0 ? dt / 2 : dt);
    largest = std::max(largest, std::abs(x - here));
    const double next = 2 * here - before + dt * dt * acceleration(here);
    before = here;
    here = next;
  }
  BOOST_TEST(largest < 1e-10);
}

// Verlet's velocities are half a step behind its positions: v_1/2 after the first step.
BOOST_AUTO_TEST_CASE(verlet_s_velocity_is_that_of_half_a_step_before) {
  constexpr double dt = 1e-3;
  Oscillator body{.zeta = 0};
  for (int n = 0; n < 300; ++n) body.advance(Integrator::verlet, dt, n == 0);
  BOOST_TEST(std::abs(body.v + omega * std::sin(omega * 299.5 * dt)) < 1e-5);
  BOOST_TEST(std::abs(body.v + omega * std::sin(omega * 300 * dt)) > 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
