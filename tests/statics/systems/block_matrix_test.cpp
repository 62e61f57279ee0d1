#include "statics/systems/block_matrix.hpp"

#include <tbb/global_control.h>

#include <boost/test/unit_test.hpp>

#include "statics/systems/free_triangle.hpp"
#include "tests/statics/systems/bodies.hpp"

// Block matrices are compared with dense sums.

using namespace springcheck;
using namespace springcheck::statics;

BOOST_AUTO_TEST_SUITE(block_matrix_test)

// Round-off; the second assembly must not remember the first.
BOOST_AUTO_TEST_CASE(products_are_those_of_the_dense_sum_on_any_cells) {
  for (const CellPattern pattern :
       {CellPattern::hexahedron, CellPattern::tetrahedron, CellPattern::mixed}) {
    const Mesh mesh = cube(3, pattern);
    BlockMatrix matrix(patches(mesh), mesh.nodes().size());
    for (const double pull : {0.3, 0.}) {
      assemble(matrix, mesh, pull);
      const Eigen::MatrixXd expected = dense(mesh, pull);
      const Eigen::VectorXd x = random_values(expected.rows());
      Eigen::VectorXd found;
      matrix.multiply(x, found);
      BOOST_TEST((found - expected * x).norm() < 1e-14 * expected.norm() * x.norm());
    }
  }
}

BOOST_AUTO_TEST_CASE(same_bits_on_any_number_of_threads) {
  const Mesh mesh = cube(6, CellPattern::mixed);
  const auto product_on = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    threads);
    BlockMatrix matrix(patches(mesh), mesh.nodes().size());
    assemble(matrix, mesh, 0.1);
    Eigen::VectorXd found;
    matrix.multiply(random_values(3 * std::ssize(mesh.nodes())), found);
    return found;
  };
  BOOST_TEST((product_on(1) == product_on(4)));
}

// The entries are the matrix's sums, copied bit for bit.
BOOST_AUTO_TEST_CASE(triangle_has_the_entries_of_the_unknowns) {
  const Mesh mesh = cube(2);
  const Eigen::MatrixXd expected = dense(mesh, 0.2);
  std::vector<bool> is_free(3 * mesh.nodes().size(), true);
  // A corner, one component of the next, two of the middle, one of the last.
  for (const std::size_t held : {0, 1, 2, 5, 39, 41, 78}) is_free[held] = false;
  const Unknowns unknowns(is_free);
  BOOST_TEST(unknowns.count() == 3 * 27 - 7);
  BlockMatrix matrix(patches(mesh), mesh.nodes().size());
  FreeTriangle triangle(matrix, unknowns);
  assemble(matrix, mesh, 0.2);
  const Eigen::MatrixXd found = triangle.copy_of(matrix);
  const Eigen::MatrixXd free = expected(unknowns.components(), unknowns.components());
  BOOST_TEST((found - Eigen::MatrixXd(free.triangularView<Eigen::Lower>())).norm() <
             1e-14 * free.norm());
}

BOOST_AUTO_TEST_CASE(scaled_and_added_to_it_is_so) {
  const Mesh mesh = cube(1);
  BlockMatrix matrix(patches(mesh), mesh.nodes().size());
  assemble(matrix, mesh);
  matrix.scale(2);
  matrix.block(1, 4) += Matrix3::Identity();
  Eigen::MatrixXd expected = 2 * dense(mesh);
  expected.block<3, 3>(3, 12).diagonal().array() += 1;
  const Eigen::VectorXd x = random_values(24);
  Eigen::VectorXd found;
  matrix.multiply(x, found);
  BOOST_TEST((found - expected * x).norm() < 1e-14 * expected.norm() * x.norm());
}

BOOST_AUTO_TEST_CASE(unknowns_are_picked_and_spread) {
  const Unknowns unknowns({true, false, true, false, false, true});
  const Eigen::VectorXd all = Eigen::VectorXd::LinSpaced(6, 0, 5);
  BOOST_TEST((unknowns.in(all) == Eigen::Vector3d(0, 2, 5)));
  Eigen::VectorXd expected(6);
  expected << 0, 0, 2, 0, 0, 5;
  BOOST_TEST((unknowns.spread(unknowns.in(all)) == expected));
  Eigen::VectorXd cleared = all;
  unknowns.clear_prescribed(cleared);
  BOOST_TEST((cleared == expected));
  BOOST_TEST(unknowns.of(0, 2) == 1);
  BOOST_TEST(unknowns.of(1, 1) == -1);
}

BOOST_AUTO_TEST_SUITE_END()
