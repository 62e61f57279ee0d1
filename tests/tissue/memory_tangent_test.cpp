#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "tests/tissue/motions.hpp"
#include "tissue/maxwell_fit.hpp"
#include "tissue/memory.hpp"

using namespace springcheck::tissue;

BOOST_AUTO_TEST_SUITE(memory_tangent_test)

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
AfterMotion after_motion(const Solid& solid, double duration) {
  AfterMotion after{std::vector<double>(state_size(solid.shear.branches.size())),
                    identity()};
  set_to_rest(after.state);
  for (int i = 0; i < 4; ++i)
    advance(solid, memory_step(solid, duration), after.state,
            right_cauchy_green(near_identity(0.3)));
  after.C = right_cauchy_green(near_identity(0.3));
  return after;
}

/// Largest difference from central differences, over the largest entry.
struct Difference {
  double strands, volume;
};
Difference difference_of(const Solid& solid, double duration, const AfterMotion& at) {
  const MemoryStep step = memory_step(solid, duration);
  const PointTangent tangent = tangent_after(solid, step, at.state, at.C);
  PointTangent differences = tangent;
  for (int j = 0; j < 6; ++j) {
    constexpr double h = 1e-5;
    SymmetricTensor more = at.C, less = at.C;
    more[j] += h;
    less[j] -= h;
    const PointStress up = stress_after(solid, step, at.state, more);
    const PointStress down = stress_after(solid, step, at.state, less);
    differences.strands.col(j) = (up.strands - down.strands) / (2 * h);
    differences.volume[j] = (up.volume - down.volume) / (2 * h);
  }
  return {(tangent.strands - differences.strands).cwiseAbs().maxCoeff() /
              differences.strands.cwiseAbs().maxCoeff(),
          (tangent.volume - differences.volume).cwiseAbs().maxCoeff() /
              differences.volume.cwiseAbs().maxCoeff()};
}

/// dS/dC of the parts put together, S = strands + J v C^-1, by symmetric changes of C.
Eigen::Matrix<double, 6, 6> whole_tangent(const Solid& solid, double duration,
                                          const AfterMotion& at) {
  const MemoryStep step = memory_step(solid, duration);
  const PointTangent tangent = tangent_after(solid, step, at.state, at.C);
  const double v = stress_after(solid, step, at.state, at.C).volume;
  const double J = std::sqrt(determinant(at.C));
  const Eigen::Matrix3d B = matrix_of(inverse(at.C));
  Eigen::Matrix<double, 6, 6> whole = tangent.strands;
  for (int j = 0; j < 6; ++j) {
    SymmetricTensor H = SymmetricTensor::Zero();
    H[j] = 1;
    const double dJ = J / 2 * contraction(inverse(at.C), H);
    whole.col(j) += (dJ * v + J * tangent.volume[j]) * inverse(at.C) -
                    J * v * symmetric_tensor(B * matrix_of(H) * B);
  }
  whole.bottomRows<3>() *= 2;  // what S_ij and S_ji do on a change of C
  return whole;
}

}  // namespace

// Central differences of 1e-5 have errors of 1e-10 times third derivatives, and of 1e-11
// of round-off. The steps go from a hundredth of the shortest relaxation time to some of
// the longest.
BOOST_AUTO_TEST_CASE(the_tangent_is_the_stress_s_derivative) {
  for (const Organ& organ : organs())
    for (const double bulk_ratio : {2., 500.}) {
      const Solid solid{fit_maxwell_model(organ.law).model, bulk_ratio};
      for (const double duration : {1e-4, 0.03, 1., 300.})
        for (int i = 0; i < 5; ++i) {
          const Difference difference =
              difference_of(solid, duration, after_motion(solid, duration));
          BOOST_TEST(difference.strands < 1e-6, organ.name << " dt " << duration);
          BOOST_TEST(difference.volume < 1e-6, organ.name << " dt " << duration);
        }
    }
}

// The tangent is symmetric, so that an equilibrium of a step is a minimum. The tolerance
// is round-off.
BOOST_AUTO_TEST_CASE(put_together_it_is_symmetric) {
  for (const Organ& organ : organs()) {
    const Solid solid{fit_maxwell_model(organ.law).model, 50};
    for (const double duration : {1e-3, 1., 100.}) {
      const auto K = whole_tangent(solid, duration, after_motion(solid, duration));
      BOOST_TEST((K - K.transpose()).norm() < 1e-11 * K.norm(), organ.name);
    }
  }
}

// At rest nothing has hardened. Only what follows at once resists: G f of a branch less
// and the dashpot more, and the volume, - M/3 of each strand that is stretched with it. p
// < 2 leaves M' infinite there, and no NaN.
BOOST_AUTO_TEST_CASE(at_rest_only_what_follows_at_once_resists) {
  const Solid solid{{.elastic = {400, 300},
                     .branches = {{0.5, {100, 200}}},
                     .viscosity = 3,
                     .linear_limit = 0.4,
                     .hardening_index = 0.7},
                    5};
  std::vector<double> state(state_size(1));
  set_to_rest(state);
  const MemoryStep step = memory_step(solid, 0.25);
  const PointTangent tangent = tangent_after(solid, step, state, identity());
  const double followed = step.decays[0].from_new * 100;
  const Eigen::Matrix<double, 6, 6> expected =
      (3 / 0.25 - followed) * Eigen::Matrix<double, 6, 6>::Identity() +
      (followed - 500) / 3 * identity() * identity().transpose();
  BOOST_TEST((tangent.strands - expected).norm() < 1e-11);
  BOOST_TEST((tangent.volume - 500 * (5. + 1) / 2 * identity()).norm() < 1e-11);
}

BOOST_AUTO_TEST_SUITE_END()
