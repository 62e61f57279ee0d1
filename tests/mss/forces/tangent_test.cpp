#include "mss/forces/tangent.hpp"

#include <Eigen/Dense>
#include <boost/test/unit_test.hpp>

#include "mss/forces/forces.hpp"
#include "tests/mss/assembled.hpp"
#include "tests/mss/blocks.hpp"

using namespace springcheck;
using namespace springcheck::mss;

BOOST_AUTO_TEST_SUITE(tangent_test)

namespace {

/// 2^3 cells of edge 2 m (so that no volume is 1) and E = 1 Pa: stiffnesses are of the
/// order of 1.
Network soft_block(SpringModel model, double nu,
                   StrainMeasure measure = StrainMeasure::engineering) {
  return build_network(cube(2, 2),
                       {.young_modulus = 1, .poisson_ratio = nu, .density = 1},
                       springs_in(measure, model));
}

std::vector<Vector3> deformed(const Network& network, unsigned seed) {
  return sum(network.rest_positions,
             random_field(network.rest_positions.size(), 0.6, seed));
}

/// The patches put together in the plainest way, all nodes.
Eigen::MatrixXd dense(const Network& network, const Tangent& tangent) {
  const auto unknowns = static_cast<Eigen::Index>(3 * network.masses.size());
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(unknowns, unknowns);
  const auto add = [&](std::span<const NodeIndex> nodes, const Eigen::MatrixXd& patch) {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j < nodes.size(); ++j)
        K.block<3, 3>(3 * Eigen::Index{nodes[i]}, 3 * Eigen::Index{nodes[j]}) +=
            patch.block<3, 3>(static_cast<Eigen::Index>(3 * i),
                              static_cast<Eigen::Index>(3 * j));
  };
  const auto of_patches = patches(network);
  for (std::size_t p = 0; p < of_patches.size(); ++p)
    add(of_patches[p], part(tangent, p));
  return K;
}

Eigen::VectorXd stacked_forces(const Network& network, const std::vector<Vector3>& x) {
  std::vector<Vector3> forces(x.size());
  nodal_forces(network, x, forces);
  Eigen::VectorXd stacked(static_cast<Eigen::Index>(3 * x.size()));
  for (std::size_t n = 0; n < x.size(); ++n)
    stacked.segment<3>(static_cast<Eigen::Index>(3 * n)) = forces[n];
  return stacked;
}

}  // namespace

// The slope is a central difference with a step of 1e-5 m: truncation is of the order of
// step^2 = 1e-10, round-off 1e-16/1e-5 = 1e-11 of the forces.
BOOST_AUTO_TEST_CASE(patches_add_up_to_minus_the_slope_of_the_forces) {
  constexpr double step = 1e-5;
  for (const auto& [name, model] : models)
    for (const double nu : {-0.2, 0., 0.25, 0.4, 0.49})
      for (const StrainMeasure measure : all_measures) {
        const Network network = soft_block(model, nu, measure);
        std::vector<Vector3> x = deformed(network, 1);
        const Eigen::MatrixXd K = dense(network, tangent_at(network, x));
        Eigen::MatrixXd slopes(K.rows(), K.cols());
        for (Eigen::Index column = 0; column < K.cols(); ++column) {
          double& coordinate = x[static_cast<std::size_t>(column / 3)][column % 3];
          const double here = coordinate;
          coordinate = here + step;
          const Eigen::VectorXd ahead = stacked_forces(network, x);
          coordinate = here - step;
          slopes.col(column) = (ahead - stacked_forces(network, x)) / (2 * step);
          coordinate = here;
        }
        BOOST_TEST(
            (K + slopes).cwiseAbs().maxCoeff() < 1e-8 * K.cwiseAbs().maxCoeff(),
            name << ", nu = " << nu << ", strain measure " << static_cast<int>(measure));
      }
}

// The positive part of every patch, cells and nodal patches, has no negative eigenvalue
// beyond round-off, and its energy along any field is as large as that of the patch.
BOOST_AUTO_TEST_CASE(positive_parts_have_no_negative_eigenvalue) {
  const auto check = [](const Network& network, std::size_t& clamped) {
    const Tangent tangent = tangent_at(network, deformed(network, 1));
    for (std::size_t p = 0; p < patches(network).size(); ++p) {
      const auto lowest = [](const Eigen::MatrixXd& K) {
        return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues().minCoeff();
      };
      const Eigen::MatrixXd K = part(tangent, p), positive = positive_part(tangent, p);
      const double round_off = 1e-12 * K.norm();
      BOOST_TEST(lowest(positive) > -round_off);
      BOOST_TEST(lowest(positive - K) > -round_off);
      if (lowest(K) < -round_off && p >= network.cells.size()) ++clamped;
    }
  };
  std::size_t clamped_patches = 0;
  check(soft_block(SpringModel::cf, .4), clamped_patches);
  const Mesh tetrahedra = generate_block(
      {.size = {4, 4, 4}, .cells = {2, 2, 2}, .pattern = CellPattern::tetrahedron});
  for (const double nu : {.1, .4})  // below 1/4 the volume modulus is negative
    check(
        build_network(tetrahedra, {.young_modulus = 1, .poisson_ratio = nu, .density = 1},
                      springs_in(StrainMeasure::engineering, SpringModel::affine)),
        clamped_patches);
  BOOST_TEST(clamped_patches > 0U);
}

// A swollen cell's springs all pull, and its tangent has no negative eigenvalue:
// round-off.
BOOST_AUTO_TEST_CASE(the_positive_part_of_a_positive_tangent_is_itself) {
  const Network network = soft_block(SpringModel::cf, 0.4);
  std::vector<Vector3> x = network.rest_positions;
  for (Vector3& place : x) place *= 1.01;
  const Tangent tangent = tangent_at(network, x);
  for (std::size_t c = 0; c < network.cells.size(); ++c) {
    const Eigen::MatrixXd K = part(tangent, c);
    BOOST_TEST((positive_part(tangent, c) - K).norm() < 1e-13 * K.norm());
  }
}

// The tolerance is round-off: of a patch's matrix the other triangle is taken.
BOOST_AUTO_TEST_CASE(
    assembly_is_the_lower_triangle_of_the_dense_one_over_the_free_components) {
  const Network network = soft_block(SpringModel::cf, 0.4);
  std::vector<bool> is_free(3 * network.masses.size(), true);
  std::vector<Eigen::Index> rows;
  // A corner, one component of the next, two of the middle, one of the last.
  for (const std::size_t component : {0, 1, 2, 5, 39, 41, 78}) is_free[component] = false;
  for (std::size_t i = 0; i < is_free.size(); ++i)
    if (is_free[i]) rows.push_back(static_cast<Eigen::Index>(i));
  const Tangent tangent = tangent_at(network, deformed(network, 1));
  const Eigen::MatrixXd expected =
      dense(network, tangent)(rows, rows).triangularView<Eigen::Lower>();
  BOOST_TEST(
      (Eigen::MatrixXd(lower_triangle(network, tangent, is_free)) - expected).norm() <
      1e-15 * expected.norm());
}

BOOST_AUTO_TEST_SUITE_END()
