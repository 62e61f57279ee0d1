#include "statics/systems/system.hpp"

#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>

#include "tests/statics/systems/bodies.hpp"

// Every solver against the dense matrix.

using namespace springcheck;
using namespace springcheck::statics;

BOOST_AUTO_TEST_SUITE(system_test)

namespace {

constexpr LinearSolver all_solvers[] = {
    LinearSolver::direct, LinearSolver::conjugate_gradients, LinearSolver::multigrid};

struct Case {
  Mesh mesh = cube(4);
  System system;
  Eigen::MatrixXd free{};  // the matrix of the unknowns, dense

  explicit Case(LinearSolver solver, int iteration_limit = 20'000)
      : system(mesh.nodes(), patches(mesh), held_below(mesh), solver, iteration_limit) {
    pull(0);
    system.prepare();
  }
  void pull(double by) {
    assemble(system.matrix(), mesh, by);
    const auto& unknowns = system.unknowns().components();
    free = dense(mesh, by)(unknowns, unknowns);
  }
  [[nodiscard]] double lowest() const {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(free, Eigen::EigenvaluesOnly)
        .eigenvalues()[0];
  }
};

}  // namespace

// The iterative ones to 1e-12 in the preconditioner's norm, times a condition of 1e3.
BOOST_AUTO_TEST_CASE(solutions_are_those_of_the_dense_matrix) {
  for (const LinearSolver solver : all_solvers) {
    Case body(solver);
    for (const double pull : {0., 0.1}) {  // the second with the first's preconditioner
      body.pull(pull);
      body.system.prepare();
      const Eigen::VectorXd right = random_values(body.free.rows());
      const Eigen::VectorXd expected = body.free.llt().solve(right);
      const auto found = body.system.solve(right, 1e-12);
      BOOST_TEST_REQUIRE(found.has_value());
      BOOST_TEST((*found - expected).norm() < 1e-9 * expected.norm());
    }
    BOOST_TEST(body.system.truncated() == 0);
    BOOST_TEST(body.system.iterations().has_value() == (solver != LinearSolver::direct));
    BOOST_TEST(body.system.factorisations().value_or(-1) ==
               (solver == LinearSolver::direct ? 3 : -1));
  }
}

// Compressed springs push aside, more and more: definite or not is told as by the lowest
// eigenvalue, down to 1e-4 of the pull at which it vanishes.
BOOST_AUTO_TEST_CASE(definite_is_told_from_indefinite) {
  Case dense_body(LinearSolver::direct);
  double stable = 0, unstable = -0.5;
  for (int bisection = 0; bisection < 20; ++bisection) {
    const double pull = (stable + unstable) / 2;
    dense_body.pull(pull);
    (dense_body.lowest() > 0 ? stable : unstable) = pull;
  }
  for (const LinearSolver solver : all_solvers) {
    Case body(solver);
    std::mt19937_64 random(1);
    for (const double near : {-0.1, -1e-2, -1e-4, 1e-4, 1e-2, 0.1}) {
      body.pull(stable * (1 + near));
      body.system.prepare();
      BOOST_TEST(body.system.is_definite(random).value() == (near < 0),
                 static_cast<int>(solver) << " at " << near);
      if (near < 0) continue;
      const Eigen::VectorXd v = body.system.negative_curvature(random);
      BOOST_TEST(std::abs(v.norm() - 1) < 1e-12);
      BOOST_TEST(v.dot(body.free * v) < 0);
    }
  }
}

// Far on the other side conjugate gradients meet negative curvature at once, and give no
// solution unasked.
BOOST_AUTO_TEST_CASE(indefinite_matrices_have_no_solution) {
  for (const LinearSolver solver : all_solvers) {
    Case body(solver);
    body.pull(-0.5);
    body.system.prepare();
    BOOST_TEST(!body.system.solve(random_values(body.free.rows()), 1e-10).has_value());
  }
}

// Held nowhere: six motions without stiffness, and the shift of 1e-8 of the largest entry
// keeps them within bounds.
BOOST_AUTO_TEST_CASE(semidefinite_matrices_are_shifted) {
  const Mesh mesh = cube(3);
  const std::vector<bool> is_free(3 * mesh.nodes().size(), true);
  const Eigen::MatrixXd matrix = dense(mesh);
  const Eigen::VectorXd image = matrix * random_values(matrix.rows());
  for (const LinearSolver solver : all_solvers) {
    System system(mesh.nodes(), patches(mesh), is_free, solver);
    assemble(system.matrix(), mesh);
    system.prepare_semidefinite();
    const auto found = system.solve(image, 1e-10);
    BOOST_TEST_REQUIRE(found.has_value(), static_cast<int>(solver));
    BOOST_TEST((matrix * *found - image).norm() < 1e-5 * image.norm());
    std::mt19937_64 random(1);
    BOOST_TEST(system.is_definite(random).value());
  }
}

// Three iterations neither solve nor tell, and what they cut short is counted.
BOOST_AUTO_TEST_CASE(truncated_solutions_are_counted) {
  Case body(LinearSolver::conjugate_gradients, 3);
  std::mt19937_64 random(1);
  BOOST_TEST(!body.system.is_definite(random).has_value());
  const Eigen::VectorXd right = random_values(body.free.rows());
  const auto found = body.system.solve(right, 1e-10);
  BOOST_TEST(found.value().dot(right) > 0);
  BOOST_TEST(body.system.truncated() == 1);
  BOOST_TEST(body.system.solve(right, 0.99).has_value());
  BOOST_TEST(body.system.truncated() == 1);
}

BOOST_AUTO_TEST_CASE(nothing_free_is_nothing_to_solve) {
  const Mesh mesh = cube(1);
  for (const LinearSolver solver :
       {LinearSolver::direct, LinearSolver::conjugate_gradients}) {
    System system(mesh.nodes(), patches(mesh), std::vector<bool>(24, false), solver);
    assemble(system.matrix(), mesh);
    system.prepare();
    std::mt19937_64 random(1);
    BOOST_TEST(system.is_definite(random).value());
    BOOST_TEST(system.solve(Eigen::VectorXd(0), 1e-10).value().size() == 0);
  }
}

BOOST_AUTO_TEST_CASE(prepared_shifted_whatever_it_is) {
  Case body(LinearSolver::direct);
  BOOST_TEST(prepare_shifted(body.system));
  body.pull(-0.5);
  BOOST_TEST(!prepare_shifted(body.system));
  const Eigen::VectorXd right = random_values(body.free.rows());
  BOOST_TEST(body.system.solve(right, 0).value().dot(right) > 0);
}

BOOST_AUTO_TEST_CASE(the_solver_is_taken_by_size_where_none_is_wanted) {
  using enum LinearSolver;
  for (const auto& [unknowns, expected] :
       {std::pair{10'000, direct}, std::pair{10'001, conjugate_gradients},
        std::pair{250'000, conjugate_gradients}, std::pair{250'001, multigrid}})
    BOOST_TEST((linear_solver_taken(automatic, unknowns) == expected));
  for (const LinearSolver wanted : all_solvers)
    BOOST_TEST((linear_solver_taken(wanted, 300'000) == wanted));
}

BOOST_AUTO_TEST_SUITE_END()
