#define BOOST_TEST_MODULE memory_energy
#include "tissue/memory_energy.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "motions.hpp"
#include "tissue/maxwell_fit.hpp"

using namespace springcheck::tissue;

namespace {

std::mt19937_64 engine{2018};

double between(double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(engine);
}

/// exp of a symmetric matrix.
SymmetricTensor exponential(const Eigen::Matrix3d& H) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(H);
  return symmetric_tensor(eigen.eigenvectors() *
                          eigen.eigenvalues().array().exp().matrix().asDiagonal() *
                          eigen.eigenvectors().transpose());
}

/// ln C of largest entries `strain`, and the trace ln det C within `volume` of 0.
Eigen::Matrix3d random_strain(double strain, double volume) {
  Eigen::Matrix3d H =
      Eigen::Matrix3d::NullaryExpr([&] { return between(-strain, strain); });
  H = (H + H.transpose()).eval() / 2;
  H.diagonal().array() += (between(-volume, volume) - H.trace()) / 3;
  return H;
}

/// The least dissipation over the largest size that it has in its history, of 1000
/// histories of 24 steps each: straight in ln C between random strains, steps from 1e-4
/// to 1e3 s, through all organs.
double least_dissipation(const std::array<MaxwellModel, 3>& models, double volume) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t history = 0; history < 1000; ++history) {
    const MaxwellModel& model = models[history % 3];
    const MemoryStep step = memory_step(model, std::pow(10, between(-4, 3)));
    std::vector<double> state(state_size(model.branches.size()));
    set_to_rest(state);
    const double strain = std::pow(10, between(-3, 0.2));
    Eigen::Matrix3d from = Eigen::Matrix3d::Zero();
    double lowest = 0, largest = 1e-300;
    for (int knot = 0; knot < 4; ++knot) {
      const Eigen::Matrix3d to = random_strain(strain, volume);
      for (int i = 1; i <= 6; ++i) {
        const std::vector<double> before = state;
        advance(model, step, state, exponential(from + i / 6. * (to - from)));
        const double power = dissipation(model, step, before, state);
        lowest = std::min(lowest, power);
        largest = std::max(largest, std::abs(power));
      }
      from = to;
    }
    least = std::min(least, lowest / largest);
  }
  return least;
}

std::array<MaxwellModel, 3> fitted_models() {
  std::array<MaxwellModel, 3> models;
  for (std::size_t i = 0; i < 3; ++i)
    models[i] = fit_maxwell_model(organs()[i].law).model;
  return models;
}

const MaxwellModel model{.elastic = {400, 300},
                         .branches = {{0.05, {200, 150}}, {0.5, {100, 0}}, {9, {80, 90}}},
                         .viscosity = 0.5,
                         .linear_limit = 0.4,
                         .hardening_index = 1.6};

}  // namespace

// A power of 0 is known to the round-off of tr (C A) - 3.
BOOST_AUTO_TEST_CASE(a_motion_that_keeps_its_volume_never_gives_off_energy) {
  BOOST_TEST(least_dissipation(fitted_models(), 0) > -1e-9);
}

// Any change of volume, det C from 1/e to e.
BOOST_AUTO_TEST_CASE(branches_that_do_not_harden_never_give_off_energy) {
  std::array<MaxwellModel, 3> models = fitted_models();
  for (MaxwellModel& each : models)
    for (MaxwellBranch& branch : each.branches) branch.moduli.hardening = 0;
  BOOST_TEST(least_dissipation(models, 1) > -1e-9);
}

// The bound of what is claimed: a lasting change of volume stays in I, and small strains
// beside it can then take energy out of B_i's part.
BOOST_AUTO_TEST_CASE(hardening_ones_can_beside_a_change_of_volume) {
  BOOST_TEST(least_dissipation(fitted_models(), 0.01) < -0.1);
}

// Work of S, with the pressure that makes rest free of stress, is energy stored and heat.
// The sum over steps is of second order but for the dashpot's first; errors are halved at
// least as steps are.
BOOST_AUTO_TEST_CASE(work_is_energy_stored_and_heat) {
  const auto C_at = [](double t) {
    Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
    F(0, 1) = 0.8 * std::sin(3 * t);
    F(1, 2) = 0.4 * t;
    F(2, 2) = 1 - 0.05 * t;
    F(1, 0) = -0.2 * t * t;
    return right_cauchy_green(F);
  };
  const auto imbalance = [&](int steps) {
    const MemoryStep step = memory_step(model, 2. / steps);
    std::vector<double> state(state_size(3));
    set_to_rest(state);
    double work = 0, heat = 0, power = 0;
    SymmetricTensor C = identity(), S = SymmetricTensor::Zero();
    for (int i = 1; i <= steps; ++i) {
      const std::vector<double> before = state;
      const SymmetricTensor next = C_at(2. * i / steps);
      const PointStress stress = advance(model, step, state, next);
      const SymmetricTensor next_S =
          stress.second_piola_kirchhoff - stress.stiffness_sum * inverse(next);
      const double next_power = dissipation(model, step, before, state);
      work += contraction(S + next_S, next - C) / 4;
      heat += (power + next_power) / 2 * step.duration;
      C = next;
      S = next_S;
      power = next_power;
    }
    const double stored = free_energy(model, state, C);
    BOOST_TEST(stored > 0);
    BOOST_TEST(heat > 0.1 * work);
    return std::abs(work - stored - heat) / work;
  };
  const double coarse = imbalance(1000), fine = imbalance(2000);
  BOOST_TEST_MESSAGE("imbalance " << coarse << ", " << fine);
  BOOST_TEST(fine < 1e-5);
  BOOST_TEST(fine < 0.55 * coarse);
}

BOOST_AUTO_TEST_CASE(rest_stores_nothing_and_turns_nothing_into_heat) {
  std::vector<double> state(state_size(3));
  set_to_rest(state);
  BOOST_TEST(free_energy(model, state, identity()) == 0);
  BOOST_TEST(dissipation(model, memory_step(model, 0.1), state, state) == 0);
}

// S without the dashpot and with the pressure is 2 dpsi/dC at the memories as they are;
// central differences of 1e-5.
BOOST_AUTO_TEST_CASE(stress_is_the_energy_s_derivative) {
  std::vector<double> state(state_size(3));
  set_to_rest(state);
  const MemoryStep step = memory_step(model, 0.1);
  advance(model, step, state, exponential(random_strain(0.4, 0)));
  const SymmetricTensor C = exponential(random_strain(0.4, 0));
  MaxwellModel frozen = model;  // memories that take up nothing of the step
  frozen.viscosity = 0;
  MemoryStep none = step;
  for (Decay& decay : none.decays) decay = {1, 0, 0};
  const PointStress stress = stress_after(frozen, none, state, C);
  const SymmetricTensor S =
      stress.second_piola_kirchhoff - stress.stiffness_sum * inverse(C);
  for (int j = 0; j < 6; ++j) {
    constexpr double h = 1e-5;
    SymmetricTensor more = C, less = C;
    more[j] += h;
    less[j] -= h;
    const double derivative =
        (free_energy(model, state, more) - free_energy(model, state, less)) / (2 * h);
    BOOST_TEST(derivative == (j < 3 ? 0.5 : 1) * S[j],
               boost::test_tools::tolerance(1e-6));
  }
}
