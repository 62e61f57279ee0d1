#include "statics/systems/multigrid.hpp"

#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>

#include "fem_reference/solve.hpp"
#include "fem_reference/statics/supports.hpp"
#include "statics/systems/system.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"
#include "tests/referee/figures.hpp"

// The iterative solver against the direct one, and against dense eigenvalues.

using namespace springcheck;
using namespace springcheck::fem_reference;
using statics::LinearSolver;

BOOST_AUTO_TEST_SUITE(multigrid_test)

namespace {

const Material material = of_poisson_ratio(0.25);

Solution solved(const Mesh& mesh, const Scene& scene, const Settings& settings,
                LinearSolver solver) {
  return solve(mesh, scene, settings, {.linear_solver = solver});
}

/// Checks that both solvers end in the same state, up to `band` of the largest
/// displacement and reaction. Returns multigrid's solution.
Solution check_same(const Mesh& mesh, const Scene& scene, const Settings& settings,
                    double band) {
  const Solution direct = solved(mesh, scene, settings, LinearSolver::direct),
                 iterative = solved(mesh, scene, settings, LinearSolver::multigrid);
  BOOST_TEST((iterative.status == direct.status), iterative.reason);
  const auto round_off = boost::test_tools::tolerance(1e-12);
  BOOST_TEST(iterative.load_fraction == direct.load_fraction, round_off);
  BOOST_TEST(iterative.definite_up_to.value_or(1) == direct.definite_up_to.value_or(1),
             round_off);
  BOOST_TEST(!direct.linear_iterations.has_value());
  BOOST_TEST(iterative.linear_iterations.value() > 0);
  double u = 0, u_apart = 0, r = 0, r_apart = 0;
  for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
    u = std::max(u, direct.displacements[n].norm());
    r = std::max(r, direct.reactions[n].norm());
    u_apart =
        std::max(u_apart, (iterative.displacements[n] - direct.displacements[n]).norm());
    r_apart = std::max(r_apart, (iterative.reactions[n] - direct.reactions[n]).norm());
  }
  BOOST_TEST(u_apart < band * u);
  BOOST_TEST(r_apart < band * r);
  return iterative;
}

/// Sliding plates, 10 % apart, and pins against the rigid motions left.
Scene uniaxial(double nu) {
  constexpr Held z_only{false, false, true};
  return {.material = of_poisson_ratio(nu),
          .plates = {plate("bottom", translation(Vector3::Zero()), z_only),
                     plate("top", translation({0, 0, 0.1 * edge}), z_only)},
          .pins = {{.point = Vector3::Zero(), .held = {true, true, false}},
                   {.point = Vector3(edge, 0, 0), .held = {false, true, false}}},
          .gravity = Vector3::Zero()};
}

/// A body between plates whose sides bulge as St-Venant's law would have it, compressed
/// step by step: its tangent loses definiteness on the way.
struct Squeezed {
  Discretisation body = discretise(cube(4), Element::q1_sri);
  std::vector<bool> is_free;
  CellLaw law{.constitution = st_venant_kirchhoff(lame_constants(material)),
              .dilatation = DilatationTaken::cell_mean};

  Squeezed() {
    const Mesh mesh = cube(4);
    const Scene plates = between_plates(material, {0, 0, -edge});
    is_free = Supports(mesh, plates, body).is_free();
  }
  [[nodiscard]] Eigen::VectorXd displacements(double strain) const {
    return nodal(body, [&](const Vector3& X) -> Vector3 {
      const double bulge = 0.25 * strain * (1 - std::pow(2 * X.z() / edge - 1, 2));
      // The bulge is not quite square, so that no two eigenvalues are equal.
      return {bulge * (X.x() - edge / 2), 1.1 * bulge * (X.y() - edge / 2),
              -strain * X.z()};
    });
  }
  [[nodiscard]] Eigen::VectorXd eigenvalues(double strain) const {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
               free_block(dense_tangent(body, law, displacements(strain)), is_free),
               Eigen::EigenvaluesOnly)
        .eigenvalues();
  }
  [[nodiscard]] double critical_strain() const {
    double definite = 0, indefinite = 0.5;
    for (int bisection = 0; bisection < 20; ++bisection) {
      const double strain = (definite + indefinite) / 2;
      (eigenvalues(strain)[0] > 0 ? definite : indefinite) = strain;
    }
    return definite;
  }
  void assemble(statics::BlockMatrix& matrix, double strain) const {
    const Eigen::VectorXd u = displacements(strain);
    matrix.assemble([&](std::size_t c) {
      return cell_tangent(law, *body.cells[c].shape, of_cell(u, body.cells[c]));
    });
  }
};

}  // namespace

// The tolerances are residuals of 1e-10 times the condition of these bodies, some 1e2
// (1e4 at nu = .499).
BOOST_AUTO_TEST_CASE(multigrid_and_the_direct_solver_give_the_same_states) {
  const Scene squeezed = between_plates(material, {0.02 * edge, 0, -0.1 * edge}, 0.2);
  for (const Law law : {Law::hooke, Law::hencky})
    for (const Element element : elements)
      check_same(cube(4), squeezed, {.law = law, .element = element}, 1e-8);
  check_same(cube(4), between_plates(of_poisson_ratio(0.499), {0, 0, -0.05 * edge}),
             {.law = Law::hooke, .element = Element::q1_sri}, 1e-6);
}

// The bodies have tetrahedra of a twelfth of a hexahedron's volume beside it, and
// elements that lock. Residuals are as above, with a condition of up to 1e4.
BOOST_AUTO_TEST_CASE(multigrid_solves_bodies_of_mixed_cells) {
  const Mesh mesh = cube(4, CellPattern::mixed, 0.2);
  for (const double nu : {0.25, 0.499})
    for (const Element element : {Element::q1, Element::q1_sri})
      check_same(mesh, between_plates(of_poisson_ratio(nu), {0, 0, -0.05 * edge}),
                 {.law = Law::hencky, .element = element}, 1e-6);
}

BOOST_AUTO_TEST_CASE(multigrid_solves_bodies_on_sliding_plates) {
  for (const double nu : {0.25, 0.499})
    for (const Element element : {Element::q1_sri, Element::q2})
      check_same(cube(2), uniaxial(nu), {.law = Law::hencky, .element = element}, 1e-6);
}

BOOST_AUTO_TEST_CASE(multigrid_solves_bodies_under_traction) {
  Scene pulled{.material = material,
               .plates = {fixed("bottom")},
               .tractions = {{.region = "top", .stress = {500, 0, 1000}}},
               .gravity = {0, 0, -10}};
  check_same(cube(4), pulled, {.law = Law::hencky, .element = Element::q1_sri}, 1e-8);
}

// The bodies have 3993 and 46,875 dofs, and take 11 and 12 iterations (up to 60^3 cells
// in large_test). A good hierarchy needs the same number on all grids; less than 1.5
// times is allowed.
BOOST_AUTO_TEST_CASE(iterations_hardly_grow_with_the_number_of_cells) {
  const auto iterations = [](int cells) {
    const Solution solution =
        solved(cube(cells), between_plates(material, {0, 0, -0.05 * edge}),
               {.law = Law::hooke, .element = Element::q1_sri}, LinearSolver::multigrid);
    BOOST_TEST((solution.status == SolveStatus::ok));
    BOOST_TEST(solution.force_evaluations == 2);  // one linear solve
    return solution.linear_iterations.value();
  };
  const int coarse = iterations(10), fine = iterations(24);
  BOOST_TEST(fine < 1.5 * coarse);
  BOOST_TEST(coarse < 20);
}

// Conjugate gradients on the true matrix resolve the lowest eigenvalue however close it
// is to zero: here 1e-4 of the strain before and after it vanishes.
BOOST_AUTO_TEST_CASE(definite_tangents_are_told_from_indefinite_ones) {
  const Squeezed squeezed;
  statics::System system(squeezed.body.nodes, patches(squeezed.body), squeezed.is_free,
                         LinearSolver::multigrid);
  std::mt19937_64 random(1);
  const auto is_definite = [&](double strain) {
    squeezed.assemble(system.matrix(), strain);
    system.prepare();
    return system.is_definite(random).value();
  };
  BOOST_TEST(is_definite(0));  // from here on with its hierarchy
  const double critical = squeezed.critical_strain();
  BOOST_TEST(critical > 0.3);
  for (const double near : {1e-1, 1e-2, 1e-4}) BOOST_TEST_CONTEXT(near) {
      BOOST_TEST(is_definite(critical * (1 - near)));
      BOOST_TEST(!is_definite(critical * (1 + near)));
    }
}

// St-Venant's cube of 6^3 cells loses definiteness at about 32 % of compression. Both
// solvers tell the same story: the same strain, the same last state, up to three of the
// load's steps of 1/1024 short of it.
BOOST_AUTO_TEST_CASE(loss_of_definiteness_is_found_at_the_same_strain) {
  for (const double strain : {0.325, 0.36}) {
    const Solution last =
        check_same(cube(6), between_plates(material, {0, 0, -strain * edge}),
                   {.law = Law::st_venant_kirchhoff, .element = Element::q1_sri}, 1e-6);
    BOOST_TEST((last.status == SolveStatus::no_equilibrium), last.reason);
    BOOST_TEST_REQUIRE(last.definite_up_to.has_value());
    BOOST_TEST(std::abs(*last.definite_up_to * strain -
                        referee::figure(
                            "paths", "compression fem-stvk 6 across nu 0.25 bifurcation",
                            "strain")) < 0.001);
  }
}

BOOST_AUTO_TEST_SUITE_END()
