#define BOOST_TEST_MODULE memory_tangent
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <random>

#include "motions.hpp"
#include "tissue/maxwell_fit.hpp"
#include "tissue/memory.hpp"

using namespace springcheck::tissue;

namespace {

std::mt19937_64 engine{11};

Eigen::Matrix3d near_identity(double size) {
  std::uniform_real_distribution<double> entry(-size, size);
  return Eigen::Matrix3d::Identity() +
         Eigen::Matrix3d::NullaryExpr([&] { return entry(engine); });
}

struct AfterMotion {
  std::vector<double> state;
  SymmetricTensor C;  // of the next step
};
AfterMotion after_motion(const MaxwellModel& model, double duration) {
  AfterMotion after{std::vector<double>(state_size(model.branches.size())), identity()};
  set_to_rest(after.state);
  for (int i = 0; i < 4; ++i)
    advance(model, memory_step(model, duration), after.state,
            right_cauchy_green(near_identity(0.3)));
  after.C = right_cauchy_green(near_identity(0.3));
  return after;
}

/// Largest difference from central differences, over the largest entry.
struct Difference {
  double stress, stiffness_sum;
};
Difference difference_of(const MaxwellModel& model, double duration,
                         const AfterMotion& at) {
  const MemoryStep step = memory_step(model, duration);
  const PointTangent tangent = tangent_after(model, step, at.state, at.C);
  PointTangent differences = tangent;
  for (int j = 0; j < 6; ++j) {
    constexpr double h = 1e-5;
    SymmetricTensor more = at.C, less = at.C;
    more[j] += h;
    less[j] -= h;
    const PointStress up = stress_after(model, step, at.state, more);
    const PointStress down = stress_after(model, step, at.state, less);
    differences.stress.col(j) =
        (up.second_piola_kirchhoff - down.second_piola_kirchhoff) / (2 * h);
    differences.stiffness_sum[j] = (up.stiffness_sum - down.stiffness_sum) / (2 * h);
  }
  const double scale = differences.stress.cwiseAbs().maxCoeff();
  return {
      (tangent.stress - differences.stress).cwiseAbs().maxCoeff() / scale,
      (tangent.stiffness_sum - differences.stiffness_sum).cwiseAbs().maxCoeff() / scale};
}

}  // namespace

// Central differences of 1e-5: 1e-10 times third derivatives, and 1e-11 of round-off.
// Steps from a hundredth of the shortest relaxation time to some of the longest.
BOOST_AUTO_TEST_CASE(the_tangent_is_the_stress_s_derivative) {
  for (const Organ& organ : organs()) {
    const MaxwellModel model = fit_maxwell_model(organ.law).model;
    for (const double duration : {1e-4, 0.03, 1., 300.})
      for (int i = 0; i < 5; ++i) {
        const Difference difference =
            difference_of(model, duration, after_motion(model, duration));
        BOOST_TEST(difference.stress < 1e-6, organ.name << " dt " << duration);
        BOOST_TEST(difference.stiffness_sum < 1e-6, organ.name << " dt " << duration);
      }
  }
}

// At rest nothing has hardened: - (sum f G - eta/dt) H, the stiffness of the fast
// branches and of the dashpot; p < 2 leaves dM/dI infinite there, and no NaN.
BOOST_AUTO_TEST_CASE(at_rest_only_what_follows_at_once_resists) {
  const MaxwellModel model{.elastic = {400, 300},
                           .branches = {{0.5, {100, 200}}},
                           .viscosity = 3,
                           .linear_limit = 0.4,
                           .hardening_index = 0.7};
  std::vector<double> state(state_size(1));
  set_to_rest(state);
  const MemoryStep step = memory_step(model, 0.25);
  const PointTangent tangent = tangent_after(model, step, state, identity());
  const double expected = 3 / 0.25 - step.decays[0].from_new * 100;
  BOOST_TEST(
      (tangent.stress - expected * Eigen::Matrix<double, 6, 6>::Identity()).norm() <
      1e-11);
  BOOST_TEST(tangent.stiffness_sum.norm() == 0);
}
