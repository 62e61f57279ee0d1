#include "fem_reference/statics/elasticity.hpp"

#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>

#include "meshing/cell_geometry.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"

// The discrete body: sums over its cells, and its linearisation.

using namespace springcheck;
using namespace springcheck::fem_reference;
using statics::LinearSolver;

BOOST_AUTO_TEST_SUITE(elasticity_test)

namespace {

const Material material = of_poisson_ratio(0.3);

/// All of the bottom's dofs, and the vertical ones of the top's.
std::vector<bool> plates_prescribed(const Discretisation& body) {
  std::vector<bool> prescribed(3 * body.nodes.size(), false);
  for (std::size_t n = 0; n < body.nodes.size(); ++n) {
    const double z = body.nodes[n].z();
    if (z < 1e-9) prescribed[3 * n] = prescribed[3 * n + 1] = true;
    prescribed[3 * n + 2] = z < 1e-9 || z > edge - 1e-9;
  }
  return prescribed;
}

/// Uniaxial stretch of the whole body along z.
Eigen::VectorXd stretched(const Discretisation& body, double strain) {
  return nodal(body, [&](const Vector3& X) -> Vector3 { return {0, 0, strain * X.z()}; });
}

}  // namespace

// Errors of the differences as in laws.hpp, for forces of E edge^2.
BOOST_AUTO_TEST_CASE(forces_are_the_derivative_of_the_energy) {
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = warped_cube(2, pattern);
    for (const Element element : elements_on(pattern)) {
      const Discretisation body = discretise(mesh, element);
      const std::vector<bool> prescribed(3 * body.nodes.size(), false);
      const Eigen::VectorXd u = random_nodal(body, 0.02 * edge),
                            along = random_nodal(body, edge, 3);
      for (const Law law : laws) {
        const Elasticity elasticity(body, material, {.law = law, .element = element},
                                    prescribed);
        const auto energies = [&](double d) {
          return scalar(elasticity.internal(u + d * along).energy);
        };
        const double slope = elasticity.internal(u).forces.dot(along);
        BOOST_TEST(std::abs(derivative(energies)[0] - slope) <
                   1e-8 * young * edge * edge * edge);
      }
    }
  }
}

// The forces' change along a direction, sent through step(), is that direction again, on
// free and prescribed dofs; so step() holds the exact tangent, and moves the supports.
// Error: of the differences, and for multigrid 1e-11, times the condition of some 1e3.
BOOST_AUTO_TEST_CASE(step_inverts_the_derivative_of_the_forces) {
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = cube(2, pattern, 0.2);
    for (const Element element : elements_on(pattern))
      for (const LinearSolver solver : {LinearSolver::direct, LinearSolver::multigrid})
        for (const Law law : laws)
          BOOST_TEST_CONTEXT(words(pattern) << ", " << words(law) << ' ' << words(element)
                                            << ", solver " << static_cast<int>(solver)) {
            const Discretisation body = discretise(mesh, element);
            const std::vector<bool> prescribed = plates_prescribed(body);
            const Eigen::VectorXd u = random_nodal(body, 0.01 * edge),
                                  along = random_nodal(body, edge, 3);
            Elasticity elasticity(
                body, material, {.law = law, .element = element, .linear_solver = solver},
                prescribed);
            const Eigen::VectorXd change = derivative([&](double d) -> Eigen::VectorXd {
              return elasticity.internal(u + d * along).forces;
            });
            BOOST_TEST_REQUIRE(elasticity.linearise(u));
            BOOST_TEST(elasticity.is_definite());
            const auto step = elasticity.step(change, along);
            BOOST_TEST_REQUIRE(step.has_value());
            BOOST_TEST((*step - along).norm() < 1e-7 * along.norm());
            BOOST_TEST((elasticity.linear_iterations().value_or(0) > 0) ==
                       (solver == LinearSolver::multigrid));
          }
  }
}

// St-Venant's bar loses its stiffness at a stretch of .577: far below it the tangent has
// many negative eigenvalues. The direct solver counts them all. Both solvers go on
// solving, to the accuracy above times a condition that is no longer bounded.
BOOST_AUTO_TEST_CASE(indefinite_tangents_are_told_counted_and_solved) {
  const Discretisation body = discretise(cube(3), Element::q1_sri);
  const std::vector<bool> prescribed = plates_prescribed(body);
  const Settings settings{.law = Law::st_venant_kirchhoff, .element = Element::q1_sri};
  const CellLaw law{.constitution = constitution(material, settings),
                    .dilatation = dilatation_taken(settings)};
  for (const double strain : {-0.36, -0.5}) {
    const Eigen::VectorXd u = stretched(body, strain),
                          along = random_nodal(body, edge, 3);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
        free_block(dense_tangent(body, law, u), prescribed));
    const auto negative = static_cast<int>((eigen.eigenvalues().array() < 0).count());
    BOOST_TEST_REQUIRE(negative > 0);
    for (const LinearSolver solver : {LinearSolver::direct, LinearSolver::multigrid})
      BOOST_TEST_CONTEXT("strain " << strain << ", solver " << static_cast<int>(solver)) {
        Settings chosen = settings;
        chosen.linear_solver = solver;
        Elasticity elasticity(body, material, chosen, prescribed);
        BOOST_TEST_REQUIRE(elasticity.linearise(Eigen::VectorXd::Zero(u.size())));
        BOOST_TEST(elasticity.linearise(u) == (solver == LinearSolver::multigrid));
        BOOST_TEST(!elasticity.is_definite());
        BOOST_TEST_REQUIRE(elasticity.accept_indefinite());
        if (solver == LinearSolver::direct)
          BOOST_TEST(elasticity.negative_eigenvalues().value() == negative);
        else
          BOOST_TEST(!elasticity.negative_eigenvalues().has_value());
        const Eigen::VectorXd change = dense_tangent(body, law, u) * along;
        const auto step = elasticity.step(change, along);
        BOOST_TEST_REQUIRE(step.has_value());
        BOOST_TEST((*step - along).norm() < 1e-7 * along.norm());
      }
  }
}

// Multigrid's conjugate gradients refuse to go on where they meet negative curvature.
BOOST_AUTO_TEST_CASE(multigrid_gives_no_step_in_an_indefinite_tangent_unasked) {
  const Discretisation body = discretise(cube(3), Element::q1_sri);
  const std::vector<bool> prescribed = plates_prescribed(body);
  Elasticity elasticity(body, material,
                        {.law = Law::st_venant_kirchhoff,
                         .element = Element::q1_sri,
                         .linear_solver = LinearSolver::multigrid},
                        prescribed);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(3 * 64);
  elasticity.linearise(none);
  elasticity.linearise(stretched(body, -0.5));
  BOOST_TEST(!elasticity.step(random_nodal(body, 1), none).has_value());
  BOOST_TEST(!elasticity.is_definite());
}

BOOST_AUTO_TEST_CASE(nothing_unbalanced_and_nothing_moved_is_no_step) {
  const Discretisation body = discretise(cube(2), Element::q1);
  const std::vector<bool> prescribed = plates_prescribed(body);
  Elasticity elasticity(body, material, {.law = Law::hencky, .element = Element::q1},
                        prescribed);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(3 * 27);
  BOOST_TEST_REQUIRE(elasticity.linearise(none));
  BOOST_TEST((elasticity.step(none, none).value() == none));
}

// The largest system that the automatic choice gives to the direct solver is measured
// elsewhere; here: a small one goes there, and iterations are counted with multigrid
// only.
BOOST_AUTO_TEST_CASE(small_bodies_are_solved_directly_unless_told_otherwise) {
  const Discretisation body = discretise(cube(2), Element::q1);
  const std::vector<bool> prescribed = plates_prescribed(body);
  const auto iterates = [&](LinearSolver solver) {
    return Elasticity(
               body, material,
               {.law = Law::hooke, .element = Element::q1, .linear_solver = solver},
               prescribed)
        .linear_iterations()
        .has_value();
  };
  BOOST_TEST(!iterates(LinearSolver::automatic));
  BOOST_TEST(!iterates(LinearSolver::direct));
  BOOST_TEST(iterates(LinearSolver::multigrid));
}

// Round-off.
BOOST_AUTO_TEST_CASE(homogeneous_body_reports_its_gradient_jacobian_and_volumes,
                     *boost::unit_test::tolerance(1e-12)) {
  const Matrix3 H = general_gradient();
  const double J = (Matrix3::Identity() + H).determinant();
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = warped_cube(2, pattern);
    for (const Element element : elements_on(pattern)) {
      const Discretisation body = discretise(mesh, element);
      const std::vector<bool> prescribed(3 * body.nodes.size(), false);
      const Elasticity elasticity(body, material,
                                  {.law = Law::hencky, .element = element}, prescribed);
      const Eigen::VectorXd u =
          nodal(body, [&](const Vector3& X) -> Vector3 { return H * X; });
      const Elasticity::Internal internal = elasticity.internal(u);
      BOOST_TEST(internal.mean_gradient == H.norm());
      BOOST_TEST(internal.smallest_jacobian == J);
      const std::vector<double> volumes = elasticity.cell_volumes(u);
      for (std::size_t c = 0; c < volumes.size(); ++c)
        BOOST_TEST(volumes[c] == J * mesh.cell_volumes()[c]);
    }
  }
}

// The deformed cell's exact volume. Round-off.
BOOST_AUTO_TEST_CASE(cell_volumes_are_exact_in_any_field_of_a_linear_element,
                     *boost::unit_test::tolerance(1e-12)) {
  for (const CellPattern pattern : patterns) {
    const Mesh mesh = warped_cube(2, pattern);
    const Discretisation body = discretise(mesh, Element::q1);
    const std::vector<bool> prescribed(3 * body.nodes.size(), false);
    const Elasticity elasticity(body, material,
                                {.law = Law::hooke, .element = Element::q1}, prescribed);
    const Eigen::VectorXd u = random_nodal(body, 0.05 * edge);
    std::vector<Vector3> moved = mesh.nodes();
    for (std::size_t n = 0; n < moved.size(); ++n)
      moved[n] += u.segment<3>(static_cast<Eigen::Index>(3 * n));
    const std::vector<double> expected = cell_volumes(mesh.cells(), moved);
    const std::vector<double> volumes = elasticity.cell_volumes(u);
    for (std::size_t c = 0; c < volumes.size(); ++c)
      BOOST_TEST(volumes[c] == expected[c]);
  }
}

// The rounding of the forces of a turned body, which carries none: within the estimate,
// and the estimate is not much larger (100 times).
BOOST_AUTO_TEST_CASE(round_off_estimates_the_rounding_of_the_forces) {
  const Discretisation body = discretise(cube(4), Element::q1);
  const std::vector<bool> prescribed = plates_prescribed(body);
  Elasticity elasticity(body, material, {.law = Law::hencky, .element = Element::q1},
                        prescribed);
  const Matrix3 turn = rotation(1.3, {1, 2, 3}) - Matrix3::Identity();
  const Eigen::VectorXd u =
      nodal(body, [&](const Vector3& X) -> Vector3 { return turn * X; });
  elasticity.linearise(u);
  const double rounding = elasticity.internal(u).forces.norm();
  BOOST_TEST(rounding < elasticity.round_off(u));
  BOOST_TEST(elasticity.round_off(u) < 1e-12 * young * edge * edge);
}

BOOST_AUTO_TEST_SUITE_END()
