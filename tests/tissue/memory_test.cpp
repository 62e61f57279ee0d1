#include "tissue/memory.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "tests/tissue/motions.hpp"
#include "tests/tissue/refusal.hpp"
#include "tests/tissue/shear.hpp"

using namespace springcheck;
using namespace springcheck::tissue;

BOOST_AUTO_TEST_SUITE(memory_test)

namespace {

const MaxwellModel model{.elastic = {400, 300},
                         .branches = {{0.02, {200, 150}}, {0.5, {100, 0}}, {9, {80, 90}}},
                         .viscosity = 0.5,
                         .linear_limit = 0.4,
                         .hardening_index = 1.6};

const Solid solid{model, 20};

Solid without_dashpot() {
  Solid changed = solid;
  changed.shear.viscosity = 0;
  return changed;
}

/// Stress at the end of `motion` over a second in equal steps.
template <class Motion>
SymmetricTensor stress_at_end(const Solid& body, const Motion& motion, int steps) {
  std::vector<double> state(state_size(body.shear.branches.size()));
  set_to_rest(state);
  const MemoryStep step = memory_step(body, 1. / steps);
  SymmetricTensor S = SymmetricTensor::Zero();
  for (int i = 1; i <= steps; ++i) {
    const SymmetricTensor C = right_cauchy_green(motion(i / static_cast<double>(steps)));
    S = second_piola_kirchhoff(advance(body, step, state, C), C);
  }
  return S;
}

/// The same by dA/dt = (C'^-1 - A)/tau with Runge and Kutta's steps on 3x3 matrices, none
/// of the memory's code; without the dashpot. S = sum M_i Q_i with Q_i the derivative of
/// tr(C A_i)/det^(1/3) C + r (J-1)^2 by C.
template <class Motion>
Eigen::Matrix3d stress_by_rates(const Solid& body, const Motion& motion, int steps) {
  const auto C_at = [&](double t) -> Eigen::Matrix3d {
    return motion(t).transpose() * motion(t);
  };
  const Eigen::Matrix3d C = C_at(1), I = Eigen::Matrix3d::Identity();
  const double J = motion(1).determinant();
  const auto stress_of = [&](const BranchModuli& moduli, const Eigen::Matrix3d& A) {
    const double trace = (C * A).trace() / std::pow(J, 2. / 3);
    const double strain = trace - 3 + body.bulk_ratio * (J - 1) * (J - 1);
    const double p = body.shear.hardening_index, limit = body.shear.linear_limit;
    const double M = moduli.linear + moduli.hardening *
                                         std::pow(strain / (limit * limit), p / 2) /
                                         (p + 1);
    return (M * (A / std::pow(J, 2. / 3) - trace / 3 * C.inverse() +
                 body.bulk_ratio * (J - 1) * J * C.inverse()))
        .eval();
  };
  Eigen::Matrix3d S = stress_of(body.shear.elastic, I);
  for (const auto& [tau, moduli] : body.shear.branches) {
    const auto rate = [&, tau = tau](double t, const Eigen::Matrix3d& A) {
      const Eigen::Matrix3d rest = C_at(t).inverse() * std::cbrt(C_at(t).determinant());
      return ((rest - A) / tau).eval();
    };
    Eigen::Matrix3d A = I;
    const double dt = 1. / steps;
    for (int i = 0; i < steps; ++i) {
      const double t = i * dt;
      const Eigen::Matrix3d k1 = rate(t, A), k2 = rate(t + dt / 2, A + dt / 2 * k1),
                            k3 = rate(t + dt / 2, A + dt / 2 * k2),
                            k4 = rate(t + dt, A + dt * k3);
      A += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    S += stress_of(moduli, A);
  }
  return S;
}

/// A motion that stretches, shears and turns, and lessens its volume.
Eigen::Matrix3d any_motion(double t) {
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F(0, 0) += 0.1 * std::sin(2 * t);
  F(1, 1) -= 0.1 * t;
  F(2, 2) -= 0.1 * t * t;
  F(0, 1) = 0.5 * std::sin(3 * t);
  F(1, 2) = 0.3 * t;
  F(2, 0) = -0.2 * t * t;
  return F;
}

}  // namespace

BOOST_AUTO_TEST_CASE(five_branches_take_36_doubles) {
  BOOST_TEST(state_size(5) == 36U);
}

// The tolerance is round-off of 1000 steps.
BOOST_AUTO_TEST_CASE(rest_stays_at_rest_without_stress) {
  std::vector<double> state(state_size(3));
  set_to_rest(state);
  const std::vector<double> at_rest = state;
  const MemoryStep step = memory_step(solid, 0.01);
  for (int i = 0; i < 1000; ++i) {
    const PointStress stress = advance(solid, step, state, identity());
    BOOST_TEST(stress.volume == -780, boost::test_tools::tolerance(1e-13));
    BOOST_TEST(second_piola_kirchhoff(stress, identity()).norm() < 1e-10);
  }
  for (std::size_t i = 0; i < state.size(); ++i)
    BOOST_TEST(std::abs(state[i] - at_rest[i]) < 1e-13);
}

BOOST_AUTO_TEST_CASE(a_past_fades_whatever_the_step) {
  for (const double ratio : {1e-12, 1e-6, 1e-3, 1., 30., 1e6}) {
    const Decay decay =
        memory_step({{{0, 0}, {{2, {1, 1}}}, 0, 1, 1}, 20}, 2 * ratio).decays.front();
    BOOST_TEST(decay.kept == std::exp(-ratio), boost::test_tools::tolerance(1e-14));
    BOOST_TEST(decay.kept + decay.from_old + decay.from_new == 1,
               boost::test_tools::tolerance(1e-15));
    BOOST_TEST(decay.from_old >= 0);
    BOOST_TEST(decay.from_new > 0);
    // f = 1 - (1-e)/x; below 1e-3 its series x/2 - x^2/6 + x^3/24.
    const double f = ratio > 0.01
                         ? 1 + std::expm1(-ratio) / ratio
                         : ratio / 2 - ratio * ratio / 6 + ratio * ratio * ratio / 24;
    BOOST_TEST(decay.from_new == f, boost::test_tools::tolerance(1e-10));
  }
}

// With C^-1 held or straight in time the update is exact, in one step or a thousand.
BOOST_AUTO_TEST_CASE(one_long_step_is_many_short_ones_where_c_is_held) {
  ShearedPoint one(model), many(model);
  one.move(0, 0.5, 0.1, 10);
  many.move(0, 0.5, 0.1, 10);
  BOOST_TEST(one.move(0.5, 0.5, 4, 1) == many.move(0.5, 0.5, 4, 1000),
             boost::test_tools::tolerance(1e-12));
}

// Runge and Kutta's error is below 1e-9; ours falls by four as steps are halved.
BOOST_AUTO_TEST_CASE(branches_are_of_second_order_in_any_motion) {
  const SymmetricTensor exact =
      symmetric_tensor(stress_by_rates(solid, any_motion, 4000));
  const auto error = [&](int steps) {
    return (stress_at_end(without_dashpot(), any_motion, steps) - exact).norm();
  };
  BOOST_TEST(error(1600) < 1e-5 * exact.norm());
  for (const int steps : {100, 200, 400}) {
    const double order = std::log2(error(steps) / error(2 * steps));
    BOOST_TEST(std::abs(order - 2) < 0.1, "order " << order << " at " << steps);
  }
}

// The difference of C^-1 over the step stands for its rate at the end.
BOOST_AUTO_TEST_CASE(the_dashpot_is_of_first_order) {
  const Solid dashpot{{{0, 0}, {}, 2, 1, 1}, 20};
  constexpr double h = 1e-5;
  const auto inverse_at = [](double t) {
    return inverse(right_cauchy_green(any_motion(t)));
  };
  const SymmetricTensor exact = -2 * (inverse_at(1 + h) - inverse_at(1 - h)) / (2 * h);
  const auto error = [&](int steps) {
    return (stress_at_end(dashpot, any_motion, steps) - exact).norm();
  };
  BOOST_TEST(error(1000) < 0.005 * exact.norm());
  const double order = std::log2(error(200) / error(400));
  BOOST_TEST(std::abs(order - 1) < 0.05, "order " << order);
}

// The stresses are the closed forms of simple shear at any strain, here to 3, to second
// order in dt.
BOOST_AUTO_TEST_CASE(simple_shear_is_that_of_the_branches) {
  for (const double rate : {0.1, 5.}) {
    const double expected = constant_rate_stress(model, 3, rate);
    const auto error = [&](int steps) {
      return std::abs(ShearedPoint(model).move(0, 3, 3 / rate, steps) / expected - 1);
    };
    BOOST_TEST(error(2000) < 1e-5);
    const double order = std::log2(error(500) / error(1000));
    BOOST_TEST(std::abs(order - 2) < 0.1, "order " << order);
  }
  ShearedPoint held(model);
  held.move(0, 2, 4, 4000);
  BOOST_TEST(held.move(2, 2, 0.7, 1) == ramp_and_hold_stress(model, 2, 0.5, 0.7),
             boost::test_tools::tolerance(1e-5));
}

// F -> Q F with any Q(t): C, and so S, to round-off, and F S F^T turns with Q.
BOOST_AUTO_TEST_CASE(turning_the_body_turns_its_stress) {
  const auto turning = [](double t) { return rotation({1, -2, 0.5}, 4 * t); };
  const SymmetricTensor S = stress_at_end(solid, any_motion, 50);
  const SymmetricTensor turned = stress_at_end(
      solid, [&](double t) -> Eigen::Matrix3d { return turning(t) * any_motion(t); }, 50);
  BOOST_TEST((turned - S).norm() < 1e-11 * S.norm());
}

// F -> F Q^T: S turns, all of the past with it.
BOOST_AUTO_TEST_CASE(the_tissue_is_isotropic) {
  const Eigen::Matrix3d Q = rotation({0.3, 1, -1}, 1.1);
  const SymmetricTensor S = stress_at_end(solid, any_motion, 50);
  const SymmetricTensor other = stress_at_end(
      solid, [&](double t) -> Eigen::Matrix3d { return any_motion(t) * Q.transpose(); },
      50);
  BOOST_TEST((matrix_of(other) - Q * matrix_of(S) * Q.transpose()).norm() <
             1e-11 * S.norm());
}

BOOST_AUTO_TEST_CASE(many_points_are_each_as_one) {
  constexpr std::size_t points = 5;
  const std::size_t size = state_size(model.branches.size());
  const MemoryStep step = memory_step(solid, 0.05);
  std::vector<double> states(points * size), single(points * size);
  set_to_rest(states);
  set_to_rest(single);
  std::vector<PointStress> stresses(points);
  for (int i = 1; i <= 3; ++i) {
    std::vector<SymmetricTensor> C;
    for (std::size_t point = 0; point < points; ++point)
      C.push_back(right_cauchy_green(any_motion(0.1 * i * static_cast<double>(point))));
    advance(solid, step, states, C, stresses);
    for (std::size_t point = 0; point < points; ++point) {
      const std::span<double> state = std::span(single).subspan(point * size, size);
      const PointStress before = stress_after(solid, step, state, C[point]);
      const PointStress expected = advance(solid, step, state, C[point]);
      BOOST_TEST((stresses[point].strands == expected.strands));
      BOOST_TEST((before.strands == expected.strands));
      BOOST_TEST(before.volume == expected.volume);
      BOOST_TEST(stresses[point].volume == expected.volume);
    }
  }
  BOOST_TEST(states == single, boost::test_tools::per_element());
}

// S = r sum M_i (J-1) J C^-1 with M_i of the mean square strain r (J-1)^2, at once and
// for good.
BOOST_AUTO_TEST_CASE(a_volume_is_elastic_and_hardens) {
  for (const double J : {0.8, 1.1}) {
    std::vector<double> state(state_size(model.branches.size()));
    set_to_rest(state);
    const SymmetricTensor C = std::pow(J, 2. / 3) * identity();
    const double squares = 20 * (J - 1) * (J - 1);
    double M = branch_stiffness(model.elastic, squares, 0.4, 1.6);
    for (const MaxwellBranch& branch : model.branches)
      M += branch_stiffness(branch.moduli, squares, 0.4, 1.6);
    for (int i = 0; i < 10; ++i) {
      const SymmetricTensor S = second_piola_kirchhoff(
          advance(without_dashpot(), memory_step(solid, 10), state, C), C);
      BOOST_TEST((S - 20 * M * (J - 1) * J * inverse(C)).norm() < 1e-11 * S.norm());
    }
  }
}

// A sudden small strain e: 2 G e beside the diagonal, K 3 e of a change of volume, with
// G = sum G_i and K = r G. Second order in e = 1e-6; and a dashpot's 2 eta e/dt.
BOOST_AUTO_TEST_CASE(small_strains_meet_shear_and_bulk_modulus) {
  constexpr double e = 1e-6, dt = 1e-5;
  const auto sudden = [](const SymmetricTensor& C) {
    std::vector<double> state(state_size(model.branches.size()));
    set_to_rest(state);
    return second_piola_kirchhoff(stress_after(solid, memory_step(solid, dt), state, C),
                                  C);
  };
  BOOST_TEST(instantaneous_modulus(model) == 780);
  SymmetricTensor C = identity();
  C[3] += 2 * e;
  BOOST_TEST(sudden(C)[3] == 2 * (780 + 0.5 / dt) * e,
             boost::test_tools::tolerance(1e-3));
  C = (1 + 2 * e) * identity();
  BOOST_TEST(sudden(C)[0] == 3 * 20 * 780 * e + 2 * 0.5 / dt * e,
             boost::test_tools::tolerance(1e-4));
}

// A step so short that memories take up 1e-6 of it; its dashpot has the rate over it, of
// first order too.
BOOST_AUTO_TEST_CASE(a_sudden_change_meets_the_memories_as_they_are) {
  constexpr double dt = 1e-8;
  std::vector<double> state(state_size(model.branches.size()));
  set_to_rest(state);
  for (const double t : {0.3, 0.6, 1.})
    advance(solid, memory_step(solid, 0.3), state, right_cauchy_green(any_motion(t)));
  const SymmetricTensor before = right_cauchy_green(any_motion(1)),
                        C = right_cauchy_green(any_motion(1 + dt));
  const PointStress now = stress_at(solid, state, C, (C - before) / dt),
                    after = stress_after(solid, memory_step(solid, dt), state, C);
  BOOST_TEST((now.strands - after.strands).norm() < 1e-5 * after.strands.norm());
  BOOST_TEST(now.volume == after.volume, boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(bulk_over_shear_modulus_is_hooke_s) {
  BOOST_TEST(bulk_ratio_of(0.25) == 5. / 3, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(bulk_ratio_of(0.499) == 2 * 1.499 / 0.006,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(refusal([] { bulk_ratio_of(0.5); }) ==
             "tissue: Poisson ratio: expected a number above -1 and below 0.5, got 0.5");
  BOOST_TEST(refusal([] { bulk_ratio_of(NAN); }) != "none");
}

BOOST_AUTO_TEST_CASE(steps_that_cannot_be_are_refused) {
  BOOST_TEST(refusal([] { memory_step(solid, 0); }) ==
             "tissue: time step [s]: expected a finite number above 0, got 0");
  BOOST_TEST(refusal([] { memory_step(solid, NAN); }) ==
             "tissue: time step [s]: expected a finite number above 0, got nan");
  BOOST_TEST(refusal([] {
               Solid changed = solid;
               changed.shear.viscosity = -1;
               memory_step(changed, 1);
             }) != "none");
  BOOST_TEST(refusal([] {
               memory_step({model, 0}, 1);
             }) ==
             "tissue: bulk over shear modulus: expected a finite number above 0, got 0");
}

BOOST_AUTO_TEST_SUITE_END()
