#include "mss/tissue/tissue_cell.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>
#include <random>

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(tissue_cell_test)

namespace {

constexpr double h = 0.005;  // [m]

const tissue::Solid solid{{.elastic = {400, 300},
                           .branches = {{0.05, {200, 150}}, {3, {100, 90}}},
                           .viscosity = 0.5,
                           .linear_limit = 0.4,
                           .hardening_index = 1.6},
                          20};

/// Cells of every type, at rest.
struct RestingCell {
  const char* name;
  CornerPositions x;
};

CornerPositions columns(std::initializer_list<Vector3> all) {
  CornerPositions x(3, static_cast<Eigen::Index>(all.size()));
  for (Eigen::Index a = 0; const Vector3& column : all) x.col(a++) = column;
  return x;
}

CornerPositions cube_at_rest() {
  return columns({{0, 0, 0},
                  {h, 0, 0},
                  {h, h, 0},
                  {0, h, 0},
                  {0, 0, h},
                  {h, 0, h},
                  {h, h, h},
                  {0, h, h}});
}

const std::vector<RestingCell>& cells() {
  static const std::vector<RestingCell> all{
      {"cube", cube_at_rest()},
      {"hexahedron", columns({{0, 0, 0},
                              {h, 0, 0.1 * h},
                              {1.1 * h, 0.9 * h, 0},
                              {0, h, 0},
                              {0.1 * h, 0, h},
                              {h, 0.1 * h, 1.2 * h},
                              {h, h, h},
                              {0, 0.8 * h, h}})},
      {"prism", columns({{0, 0, 0},
                         {h, 0, 0},
                         {0, h, 0},
                         {0, 0, h},
                         {h, 0.1 * h, h},
                         {0, h, 1.1 * h}})},
      {"pyramid",
       columns(
           {{0, 0, 0}, {h, 0, 0}, {h, h, 0}, {0, h, 0}, {0.4 * h, 0.6 * h, 0.7 * h}})},
      {"tetrahedron", columns({{0, 0, 0}, {h, 0, 0}, {0.2 * h, h, 0}, {0, 0.1 * h, h}})}};
  return all;
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

CornerPositions moved(const CornerPositions& x, double size) {
  CornerPositions y = x;
  for (double& entry : y.reshaped()) entry += random<Eigen::Vector<double, 1>>(size)[0];
  return y;
}

/// A cell whose memory has made some steps, and its next stress and tangent at x.
class Remembering {
 public:
  explicit Remembering(const CornerPositions& rest)
      : shape_(tissue_shape(rest)),
        step_(tissue::memory_step(solid, 0.03)),
        state_(tissue::state_size(solid.shear.branches.size())) {
    tissue::set_to_rest(state_);
    for (int i = 0; i < 3; ++i) {
      const Matrix3 F = near_identity(0.2);
      tissue::advance(solid, step_, state_, tissue::symmetric_tensor(F.transpose() * F));
    }
  }

  [[nodiscard]] const TissueShape& shape() const { return shape_; }
  [[nodiscard]] tissue::PointStress stress(const CornerPositions& x) const {
    return tissue::stress_after(solid, step_, state_, right_cauchy_green(shape_, x));
  }
  [[nodiscard]] CornerPositions forces(const CornerPositions& x) const {
    return tissue_forces(shape_, x, stress(x));
  }
  [[nodiscard]] TissueStiffness stiffness(const CornerPositions& x) const {
    return tissue_stiffness(
        shape_, x, stress(x),
        tissue::tangent_after(solid, step_, state_, right_cauchy_green(shape_, x)));
  }

 private:
  TissueShape shape_;
  tissue::MemoryStep step_;
  std::vector<double> state_;
};

tissue::PointStress stress_at_rest() {
  std::vector<double> state(tissue::state_size(solid.shear.branches.size()));
  tissue::set_to_rest(state);
  return tissue::stress_after(solid, tissue::memory_step(solid, 0.1), state,
                              tissue::identity());
}

}  // namespace

// Springs in tension and the volume under pressure balance to round-off: 1e-13 of either.
BOOST_AUTO_TEST_CASE(rest_is_free_of_forces) {
  const tissue::PointStress stress = stress_at_rest();
  for (const auto& [name, x] : cells()) {
    const TissueShape shape = tissue_shape(x);
    const double apart = tissue_forces(shape, x, {stress.strands, 0}).norm();
    BOOST_TEST(apart > 10 * h * h, name);
    BOOST_TEST(tissue_forces(shape, x, stress).norm() < 1e-13 * apart, name);
  }
}

BOOST_AUTO_TEST_CASE(affine_motions_have_their_own_gradient) {
  for (const auto& [name, rest] : cells()) {
    const Matrix3 F = near_identity(0.5);
    const CornerPositions x = (F * rest).colwise() + Vector3(1, -2, 3);
    BOOST_TEST((mean_deformation_gradient(tissue_shape(rest), x) - F).norm() < 1e-11,
               name);
  }
}

// A central difference of 1e-5 in time is exact but for round-off: C is of second degree.
BOOST_AUTO_TEST_CASE(the_rate_of_c_is_its_derivative) {
  for (const auto& [name, rest] : cells()) {
    const TissueShape shape = tissue_shape(rest);
    const CornerPositions x = moved(rest, 0.3 * h), v = moved(0 * rest, h);
    const tissue::SymmetricTensor difference = (right_cauchy_green(shape, x + 1e-5 * v) -
                                                right_cauchy_green(shape, x - 1e-5 * v)) /
                                               2e-5;
    BOOST_TEST((right_cauchy_green_rate(shape, x, v) - difference).norm() <
                   1e-8 * difference.norm(),
               name);
  }
}

// This holds in any state, under any stress. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(there_is_no_net_force_and_no_torque) {
  for (const auto& [name, rest] : cells())
    for (int i = 0; i < 5; ++i) {
      const CornerPositions x = moved(rest, 0.2 * h);
      const CornerPositions f = tissue_forces(tissue_shape(rest), x, random_stress());
      Vector3 torque = Vector3::Zero();
      for (Eigen::Index a = 0; a < x.cols(); ++a) torque += x.col(a).cross(f.col(a));
      BOOST_TEST(f.rowwise().sum().norm() < 1e-12 * f.norm(), name);
      BOOST_TEST(torque.norm() < 1e-12 * h * f.norm(), name);
    }
}

// f = - V F S G_a, of whatever S: what an element of one point would have.
BOOST_AUTO_TEST_CASE(a_homogeneous_cell_carries_its_stress) {
  for (const auto& [name, rest] : cells())
    for (int i = 0; i < 5; ++i) {
      const TissueShape shape = tissue_shape(rest);
      const Matrix3 F = near_identity(0.4);
      const tissue::PointStress stress = random_stress();
      const Matrix3 S = tissue::matrix_of(tissue::second_piola_kirchhoff(
          stress, tissue::symmetric_tensor(F.transpose() * F)));
      const CornerPositions expected = -shape.volume * F * S * shape.gradients;
      const CornerPositions f = tissue_forces(shape, F * rest, stress);
      BOOST_TEST((f - expected).norm() < 1e-11 * expected.norm(), name);
    }
}

// x -> Q x: the memory sees the same C, and forces turn with Q.
BOOST_AUTO_TEST_CASE(forces_turn_with_the_body) {
  const Matrix3 Q =
      Eigen::AngleAxisd(1.3, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
  for (const auto& [name, rest] : cells()) {
    const Remembering cell(rest);
    const CornerPositions x = moved(rest, 0.2 * h);
    BOOST_TEST(
        (cell.forces(Q * x) - Q * cell.forces(x)).norm() < 1e-11 * cell.forces(x).norm(),
        name);
  }
}

// Central differences of h/1e5 have errors of 1e-10 of third derivatives and 1e-11 of
// round-off.
BOOST_AUTO_TEST_CASE(stiffness_is_the_forces_derivative) {
  for (const auto& [name, rest] : cells())
    for (int i = 0; i < 3; ++i) {
      const Remembering cell(rest);
      const CornerPositions x = moved(rest, 0.1 * h);
      const TissueStiffness K = cell.stiffness(x);
      TissueStiffness differences = K;
      for (Eigen::Index j = 0; j < K.cols(); ++j) {
        constexpr double step = 1e-5 * h;
        CornerPositions more = x, less = x;
        more(j % 3, j / 3) += step;
        less(j % 3, j / 3) -= step;
        differences.col(j) =
            ((cell.forces(less) - cell.forces(more)) / (2 * step)).reshaped();
      }
      BOOST_TEST((K - differences).norm() < 1e-6 * K.norm(), name);
    }
}

BOOST_AUTO_TEST_CASE(stiffness_is_symmetric_in_homogeneous_states) {
  for (const auto& [name, rest] : cells()) {
    const Remembering cell(rest);
    const TissueStiffness K = cell.stiffness(near_identity(0.2) * rest);
    BOOST_TEST((K - K.transpose()).norm() < 1e-10 * K.norm(), name);
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
  const double modulus = h * tissue::instantaneous_modulus(solid.shear);
  for (const auto& [name, rest] : cells()) {
    const TissueStiffness K =
        tissue_stiffness(tissue_shape(rest), rest, stress_at_rest(),
                         tissue::tangent_after(elastic, step, state, tissue::identity()));
    const Eigen::MatrixXd symmetric = (K + K.transpose()) / 2;
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric).eigenvalues();
    for (Eigen::Index i = 0; i < 6; ++i)
      BOOST_TEST(std::abs(values[i]) < 1e-9 * modulus, name);
    for (Eigen::Index i = 6; i < values.size(); ++i)
      BOOST_TEST(values[i] > 0.05 * modulus, name);
  }
}

// A mode that bends a cube's edges along x, u_x = beta y x as the nodes have it, stores
// what a beam of E = 3 S_m stores: E/2 beta^2 h^5/12.
BOOST_AUTO_TEST_CASE(a_bent_cube_is_as_stiff_as_a_beam) {
  const CornerPositions rest = cube_at_rest();
  const tissue::PointStress stress = stress_at_rest();
  constexpr double beta = 1e-3 / h;
  CornerPositions bent = rest;
  for (Eigen::Index a = 0; a < 8; ++a)
    bent(0, a) += beta * (rest(0, a) - h / 2) * (rest(1, a) - h / 2);
  // Forces are linear in the bending at a stress that stays: half their work.
  const double energy =
      -(tissue_forces(tissue_shape(rest), bent, stress)).cwiseProduct(bent - rest).sum() /
      2;
  const double E = stress.strands.head<3>().sum();
  BOOST_TEST(energy == E / 2 * beta * beta * std::pow(h, 5) / 12,
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
