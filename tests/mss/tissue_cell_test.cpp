#define BOOST_TEST_MODULE tissue_cell
#include "mss/tissue/tissue_cell.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>
#include <random>

using namespace springcheck;
using namespace springcheck::mss;

namespace {

constexpr double h = 0.005;  // [m]

const tissue::Solid solid{{.elastic = {400, 300},
                           .branches = {{0.05, {200, 150}}, {3, {100, 90}}},
                           .viscosity = 0.5,
                           .linear_limit = 0.4,
                           .hardening_index = 1.6},
                          20};

HexahedronPositions at_rest() {
  HexahedronPositions x;
  x << 0, h, h, 0, 0, h, h, 0,  //
      0, 0, h, h, 0, 0, h, h,   //
      0, 0, 0, 0, h, h, h, h;
  return x;
}

std::mt19937 engine{5};

template <class Matrix>
Matrix random(double size) {
  std::uniform_real_distribution<double> entry(-size, size);
  return Matrix::NullaryExpr([&] { return entry(engine); });
}

Matrix3 near_identity(double size) {
  return Matrix3::Identity() + random<Matrix3>(size);
}

tissue::PointStress random_stress() {
  return {random<tissue::SymmetricTensor>(1000),
          std::uniform_real_distribution<double>(-3000, 3000)(engine)};
}

/// A memory after some steps, and its next stress and tangent at x.
class Remembering {
 public:
  Remembering()
      : step_(tissue::memory_step(solid, 0.03)),
        state_(tissue::state_size(solid.shear.branches.size())) {
    tissue::set_to_rest(state_);
    for (int i = 0; i < 3; ++i) {
      const Matrix3 F = near_identity(0.2);
      tissue::advance(solid, step_, state_, tissue::symmetric_tensor(F.transpose() * F));
    }
  }

  [[nodiscard]] tissue::PointStress stress(const HexahedronPositions& x) const {
    return tissue::stress_after(solid, step_, state_, right_cauchy_green(x, h));
  }
  [[nodiscard]] HexahedronPositions forces(const HexahedronPositions& x) const {
    return tissue_forces(x, h, stress(x));
  }
  [[nodiscard]] Matrix24 stiffness(const HexahedronPositions& x) const {
    return tissue_stiffness(
        x, h, stress(x),
        tissue::tangent_after(solid, step_, state_, right_cauchy_green(x, h)));
  }

 private:
  tissue::MemoryStep step_;
  std::vector<double> state_;
};

/// Of a cube at rest.
tissue::PointStress stress_at_rest() {
  std::vector<double> state(tissue::state_size(solid.shear.branches.size()));
  tissue::set_to_rest(state);
  return tissue::stress_after(solid, tissue::memory_step(solid, 0.1), state,
                              tissue::identity());
}

}  // namespace

// Springs in tension and the volume under pressure balance to round-off: 1e-14 of either.
BOOST_AUTO_TEST_CASE(rest_is_free_of_forces) {
  const tissue::PointStress stress = stress_at_rest();
  const double apart = tissue_forces(at_rest(), h, {stress.strands, 0}).norm();
  BOOST_TEST(apart > 100 * h * h);
  BOOST_TEST(tissue_forces(at_rest(), h, stress).norm() < 1e-14 * apart);
}

BOOST_AUTO_TEST_CASE(affine_motions_have_their_own_gradient) {
  const Matrix3 F = near_identity(0.5);
  const HexahedronPositions x = (F * at_rest()).colwise() + Vector3(1, -2, 3);
  BOOST_TEST((mean_deformation_gradient(x, h) - F).norm() < 1e-12);
}

// Central difference of 1e-5 in time, exact but for round-off: C is of second degree.
BOOST_AUTO_TEST_CASE(the_rate_of_c_is_its_derivative) {
  const HexahedronPositions x = at_rest() + random<HexahedronPositions>(0.3 * h),
                            v = random<HexahedronPositions>(h);
  const tissue::SymmetricTensor difference =
      (right_cauchy_green(x + 1e-5 * v, h) - right_cauchy_green(x - 1e-5 * v, h)) / 2e-5;
  BOOST_TEST((right_cauchy_green_rate(x, v, h) - difference).norm() <
             1e-9 * difference.norm());
}

// In any state, under any stress; round-off.
BOOST_AUTO_TEST_CASE(there_is_no_net_force_and_no_torque) {
  for (int i = 0; i < 20; ++i) {
    const HexahedronPositions x = at_rest() + random<HexahedronPositions>(0.4 * h);
    const HexahedronPositions f = tissue_forces(x, h, random_stress());
    Vector3 torque = Vector3::Zero();
    for (Eigen::Index a = 0; a < 8; ++a) torque += x.col(a).cross(f.col(a));
    BOOST_TEST(f.rowwise().sum().norm() < 1e-13 * f.norm());
    BOOST_TEST(torque.norm() < 1e-13 * h * f.norm());
  }
}

// f = - h^3 F S G_a, of whatever S: what a trilinear element of one point would have.
BOOST_AUTO_TEST_CASE(a_homogeneous_cell_carries_its_stress) {
  for (int i = 0; i < 20; ++i) {
    const Matrix3 F = near_identity(0.4);
    const tissue::PointStress stress = random_stress();
    const Matrix3 S = tissue::matrix_of(tissue::second_piola_kirchhoff(
        stress, tissue::symmetric_tensor(F.transpose() * F)));
    HexahedronPositions expected;
    for (Eigen::Index a = 0; a < 8; ++a) {
      const Vector3 sign = (at_rest().col(a) / h * 2).array() - 1;
      expected.col(a) = -h * h / 4 * F * S * sign;
    }
    const HexahedronPositions f = tissue_forces(F * at_rest(), h, stress);
    BOOST_TEST((f - expected).norm() < 1e-12 * expected.norm());
  }
}

// x -> Q x: the memory sees the same C, and forces turn with Q.
BOOST_AUTO_TEST_CASE(forces_turn_with_the_body) {
  const Remembering cell;
  const Matrix3 Q =
      Eigen::AngleAxisd(1.3, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
  const HexahedronPositions x = at_rest() + random<HexahedronPositions>(0.3 * h);
  BOOST_TEST((cell.forces(Q * x) - Q * cell.forces(x)).norm() <
             1e-12 * cell.forces(x).norm());
}

// Central differences of h/1e5: 1e-10 of third derivatives, 1e-11 of round-off.
BOOST_AUTO_TEST_CASE(stiffness_is_the_forces_derivative) {
  const Remembering cell;
  for (int i = 0; i < 5; ++i) {
    const HexahedronPositions x = at_rest() + random<HexahedronPositions>(0.2 * h);
    const Matrix24 K = cell.stiffness(x);
    Matrix24 differences;
    for (Eigen::Index j = 0; j < 24; ++j) {
      constexpr double step = 1e-5 * h;
      HexahedronPositions more = x, less = x;
      more(j % 3, j / 3) += step;
      less(j % 3, j / 3) -= step;
      const HexahedronPositions change =
          (cell.forces(less) - cell.forces(more)) / (2 * step);
      differences.col(j) = Eigen::Map<const Eigen::Matrix<double, 24, 1>>(change.data());
    }
    BOOST_TEST((K - differences).norm() < 1e-7 * K.norm());
  }
}

BOOST_AUTO_TEST_CASE(stiffness_is_symmetric_in_homogeneous_states) {
  const Remembering cell;
  for (int i = 0; i < 5; ++i) {
    const Matrix24 K = cell.stiffness(near_identity(0.3) * at_rest());
    BOOST_TEST((K - K.transpose()).norm() < 1e-11 * K.norm());
  }
}

// Six motions of a rigid body, and nothing else: hourglasses meet the springs' tension,
// sum M_i. At the instant, where memories follow nothing and the dashpot is left out.
BOOST_AUTO_TEST_CASE(at_rest_all_but_rigid_motions_are_resisted) {
  tissue::Solid elastic = solid;
  elastic.shear.viscosity = 0;
  std::vector<double> state(tissue::state_size(elastic.shear.branches.size()));
  tissue::set_to_rest(state);
  const tissue::MemoryStep step = tissue::memory_step(elastic, 1e-9);
  const Matrix24 K =
      tissue_stiffness(at_rest(), h, stress_at_rest(),
                       tissue::tangent_after(elastic, step, state, tissue::identity()));
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Matrix24>(K).eigenvalues();
  const double modulus = h * tissue::instantaneous_modulus(solid.shear);
  for (Eigen::Index i = 0; i < 6; ++i) BOOST_TEST(std::abs(values[i]) < 1e-9 * modulus);
  for (Eigen::Index i = 6; i < 24; ++i) BOOST_TEST(values[i] > 0.1 * modulus);
}
