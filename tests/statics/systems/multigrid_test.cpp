#include "statics/systems/multigrid.hpp"

#include <boost/test/unit_test.hpp>

#include "statics/systems/aggregation.hpp"
#include "statics/systems/chebyshev.hpp"
#include "statics/systems/system.hpp"
#include "tests/statics/systems/bodies.hpp"

BOOST_AUTO_TEST_SUITE(multigrid_test)

using namespace springcheck;
using namespace springcheck::statics;

// The bodies have 3629 and 44,999 unknowns, and take 11 and 13 iterations. A good
// hierarchy needs the same number on all grids; less than 1.5 times is allowed.
BOOST_AUTO_TEST_CASE(iterations_hardly_grow_with_the_number_of_cells) {
  const auto iterations = [](int cells) {
    const Mesh mesh = cube(cells);
    System system(mesh.nodes(), patches(mesh), held_below(mesh), LinearSolver::multigrid);
    assemble(system.matrix(), mesh);
    system.prepare();
    BOOST_TEST(system.solve(random_values(system.unknowns().count()), 1e-10).has_value());
    return system.iterations().value();
  };
  const int coarse = iterations(10), fine = iterations(24);
  BOOST_TEST(fine < 1.5 * coarse);
  BOOST_TEST(coarse < 20);
}

// The body's layers turn against each other at little cost in energy.
BOOST_AUTO_TEST_CASE(bending_of_a_slender_body_is_seen_by_the_coarse_levels) {
  const Mesh mesh = generate_block({.size = {.01, .01, .2}, .cells = {4, 4, 80}});
  System system(mesh.nodes(), patches(mesh), held_below(mesh), LinearSolver::multigrid);
  assemble(system.matrix(), mesh);
  system.prepare();
  BOOST_TEST(system.solve(random_values(system.unknowns().count()), 1e-10).has_value());
  BOOST_TEST(system.iterations().value() < 20);
}

// Conjugate gradients ask this of a preconditioner. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(cycle_is_symmetric_and_positive_and_leaves_prescribed_ones_alone) {
  const Mesh mesh = cube(10);
  const Unknowns unknowns(held_below(mesh));
  BlockMatrix matrix(patches(mesh), mesh.nodes().size());
  assemble(matrix, mesh);
  Multigrid multigrid(mesh.nodes(), unknowns);
  multigrid.prepare(matrix);
  const auto random = [&](unsigned seed) {
    return unknowns.spread(random_values(unknowns.count(), seed));
  };
  for (unsigned seed = 1; seed < 6; ++seed) {
    const Eigen::VectorXd x = random(seed), y = random(100 + seed);
    const Eigen::VectorXd Mx = multigrid.times(x), My = multigrid.times(y);
    BOOST_TEST(std::abs(y.dot(Mx) - x.dot(My)) < 1e-12 * x.norm() * My.norm());
    BOOST_TEST(x.dot(Mx) > 0);
    Eigen::VectorXd cleared = Mx;
    unknowns.clear_prescribed(cleared);
    BOOST_TEST((cleared == Mx));
  }
}

// The coarser matrices are Galerkin's: A_coarser = P^T A P. The tolerance is round-off.
BOOST_AUTO_TEST_CASE(coarser_matrices_are_those_of_the_prolonged_motions) {
  const Mesh mesh = cube(10);
  const RowMatrix matrix = dense(mesh).sparseView();
  Eigen::MatrixXd translations = Eigen::MatrixXd::Zero(matrix.rows(), 3);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) translations(i, i % 3) = 1;
  const Aggregation levels = aggregation(matrix, translations);
  BOOST_TEST_REQUIRE(levels.matrices.size() == levels.prolongations.size() + 1);
  BOOST_TEST_REQUIRE(levels.prolongations.size() > 0);
  for (std::size_t i = 0; i < levels.prolongations.size(); ++i) {
    const RowMatrix& P = levels.prolongations[i];
    const Eigen::MatrixXd expected =
        Eigen::MatrixXd(P).transpose() * (levels.matrices[i] * Eigen::MatrixXd(P));
    BOOST_TEST((Eigen::MatrixXd(levels.matrices[i + 1]) - expected).norm() <
               1e-12 * expected.norm());
  }
}

// The error falls, and that part of it whose eigenvalue is above 1/30 of the bound to
// 1/T_3(31/29) = .596.
BOOST_AUTO_TEST_CASE(smoother_reduces_the_upper_part_of_the_spectrum) {
  // D^-1 A of a chain has eigenvalues from 0 to 2, which is the bound too.
  constexpr int n = 200;
  RowMatrix chain(n, n);
  for (int i = 0; i < n; ++i) {
    chain.insert(i, i) = 2;
    if (i > 0) chain.insert(i, i - 1) = -1;
    if (i < n - 1) chain.insert(i, i + 1) = -1;
  }
  chain.makeCompressed();
  const Chebyshev smoother(chain);
  for (int k = 1; k <= n; ++k) {
    Eigen::VectorXd mode(n);
    for (int i = 0; i < n; ++i) mode[i] = std::sin(M_PI * k * (i + 1) / (n + 1));
    const double eigenvalue = 1 - std::cos(M_PI * k / (n + 1));  // of D^-1 A
    const Eigen::VectorXd left = mode - smoother.from_zero(chain, chain * mode);
    const double factor = left.norm() / mode.norm();
    BOOST_TEST(factor < 1);
    if (eigenvalue > 2. / 30) BOOST_TEST(factor < 0.597, eigenvalue);
  }
}

BOOST_AUTO_TEST_SUITE_END()
