#include "fem_reference/statics/newton.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <optional>

#include "fem_reference/statics/loads.hpp"
#include "fem_reference/statics/supports.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"
#include "tests/fem_reference/statics/log.hpp"

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(newton_test)

namespace {

/// A cube between a fixed and a moved plate, ready for newton().
struct Problem {
  Problem(int cells, const Settings& settings, double strain, double angle,
          double nu = 0.25)
      : mesh(cube(cells)),
        scene(between_plates(of_poisson_ratio(nu), {0, 0, strain * edge}, angle)),
        body(discretise(mesh, settings.element)),
        supports(mesh, scene, body),
        elasticity(body, scene.material, settings, supports.prescribed()),
        no_load(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * body.nodes.size()))) {
  }
  /// Plates moved, free nodes where they were.
  [[nodiscard]] Eigen::VectorXd only_plates_moved() const {
    return supports.displacements(1);
  }
  /// Every layer follows the plates by its height.
  [[nodiscard]] Eigen::VectorXd layers_moved() const {
    return nodal(body, [&](const Vector3& X) {
      return displacement(scene.plates[1].motion, {X.x(), X.y(), edge}, X.z() / edge);
    });
  }
  Mesh mesh;
  Scene scene;
  Discretisation body;
  Supports supports;
  Elasticity elasticity;
  Eigen::VectorXd no_load;
};

}  // namespace

// r_(k+1) <= C r_k^2 below 1e-2 and above round-off, with C below 3 at the strains of 10,
// 20 and 80 % here; the log shows it. A tangent 1 % wrong would end the series at
// r_(k+1) = .01 r_k.
BOOST_AUTO_TEST_CASE(residual_falls_quadratically) {
  for (const Law law : {Law::st_venant_kirchhoff, Law::hencky, Law::cauchy_born})
    for (const Element element : elements)
      for (const double strain : {-0.1, -0.2, 0.8})
        BOOST_TEST_CONTEXT(words(law) << ' ' << words(element) << ", strain " << strain) {
          Problem problem(3, {.law = law, .element = element}, strain, 0.3);
          const CapturedLog log;
          const NewtonResult result = newton(problem.elasticity, problem.layers_moved(),
                                             problem.no_load, Tangents::definite);
          BOOST_TEST((result.outcome == NewtonOutcome::converged));
          BOOST_TEST(result.definite);
          BOOST_TEST(result.residual < 1e-10);
          const auto calls = log.residuals();
          BOOST_TEST_REQUIRE(calls.size() == 1U);
          const std::vector<double>& r = calls.front();
          BOOST_TEST(r.size() <= 9U);
          int seen = 0;
          for (std::size_t k = 0; k + 1 < r.size(); ++k) {
            if (r[k] > 1e-2 || r[k] < 1e-7) continue;
            ++seen;
            BOOST_TEST(r[k + 1] < 10 * r[k] * r[k]);
          }
          BOOST_TEST(seen >= 1);
        }
}

BOOST_AUTO_TEST_CASE(linear_law_takes_one_step) {
  for (const Element element : elements) {
    Problem problem(3, {.law = Law::hooke, .element = element}, -0.3, 0.3);
    const NewtonResult result = newton(problem.elasticity, problem.only_plates_moved(),
                                       problem.no_load, Tangents::definite);
    BOOST_TEST((result.outcome == NewtonOutcome::converged));
    BOOST_TEST(result.force_evaluations == 2);
    BOOST_TEST(result.residual < 1e-13);
  }
}

// Where only the plates have moved, full steps turn cells inside out: without halving
// there is no way on.
BOOST_AUTO_TEST_CASE(line_search_leads_back_to_the_solution) {
  Problem problem(3, {.law = Law::hencky, .element = Element::q2}, -0.05, 0.8);
  const Eigen::VectorXd start = problem.only_plates_moved();
  const CapturedLog log;
  const NewtonResult result =
      newton(problem.elasticity, start, problem.no_load, Tangents::any);
  BOOST_TEST((result.outcome == NewtonOutcome::converged));
  const std::vector<double> r = log.residuals().front();
  BOOST_TEST(result.force_evaluations > static_cast<int>(r.size()) + 2);
  BOOST_TEST(result.internal.energy < problem.elasticity.internal(start).energy);
  const NewtonResult direct = newton(problem.elasticity, problem.layers_moved(),
                                     problem.no_load, Tangents::definite);
  BOOST_TEST((result.displacements - direct.displacements).norm() <
             1e-8 * direct.displacements.norm());
}

// A nearly incompressible body under dead loads: on the way there are states where every
// part of Newton's step raises the residual, and only the falling energy leads on.
BOOST_AUTO_TEST_CASE(energy_leads_where_the_residual_rises) {
  Problem problem(2, {.law = Law::hencky, .element = Element::q1_sri}, 0, 0, 0.499);
  const Eigen::VectorXd load =
      problem.elasticity.free_part(random_nodal(problem.body, 1));
  const CapturedLog log;
  const NewtonResult result =
      newton(problem.elasticity, problem.no_load, load, Tangents::any);
  BOOST_TEST((result.outcome == NewtonOutcome::converged));
  const std::vector<double> r = log.residuals().front();
  BOOST_TEST(!std::ranges::is_sorted(r, std::ranges::greater()));
  BOOST_TEST(result.internal.energy < load.dot(result.displacements));
}

// Equal and opposite pulls on a body that is only kept from moving rigidly: there are no
// reactions to measure the residual by, but a load.
BOOST_AUTO_TEST_CASE(balanced_loads_without_reactions_converge) {
  const Mesh mesh = cube(2);
  const Scene scene{
      .material = of_poisson_ratio(0.25),
      .plates = {},
      .pins = {{.point = Vector3::Zero(), .held = {true, true, true}},
               {.point = Vector3(edge, 0, 0), .held = {false, true, true}},
               {.point = Vector3(0, edge, 0), .held = {false, false, true}}},
      .gravity = Vector3::Zero()};
  const Discretisation body = discretise(mesh, Element::q1_sri);
  const Supports supports(mesh, scene, body);
  Elasticity elasticity(body, scene.material,
                        {.law = Law::hencky, .element = Element::q1_sri},
                        supports.prescribed());
  const Eigen::VectorXd load =
      traction_load(body, {.region = "x_max", .stress = {0.1 * young, 0, 0}}) +
      traction_load(body, {.region = "x_min", .stress = {-0.1 * young, 0, 0}});
  const NewtonResult result =
      newton(elasticity, Eigen::VectorXd::Zero(load.size()), load, Tangents::definite);
  BOOST_TEST((result.outcome == NewtonOutcome::converged));
  BOOST_TEST(result.residual < 1e-10);
}

// Forces that balance the load to 1e-10, prescribed entries as they were; the state is
// the body's own.
BOOST_AUTO_TEST_CASE(result_is_in_balance_with_the_load_on_its_supports) {
  Problem problem(3, {.law = Law::hencky, .element = Element::q1_sri}, 0.1, 0);
  const Eigen::VectorXd start = problem.layers_moved(),
                        load = random_nodal(problem.body, 0.02);  // N
  const NewtonResult result = newton(problem.elasticity, start, load, Tangents::definite);
  BOOST_TEST((result.outcome == NewtonOutcome::converged));
  const Elasticity::Internal internal = problem.elasticity.internal(result.displacements);
  BOOST_TEST(internal.energy == result.internal.energy);
  const Eigen::VectorXd unbalanced = problem.elasticity.free_part(load - internal.forces);
  const Eigen::VectorXd reactions = load - internal.forces - unbalanced;
  BOOST_TEST(unbalanced.norm() < 1e-10 * std::max(reactions.norm(), load.norm()));
  const Eigen::VectorXd moved = result.displacements - start;
  BOOST_TEST((moved - problem.elasticity.free_part(moved)).norm() == 0);
}

// St-Venant's cube at 45 %: indefinite. Asked for definite tangents, Newton says so at
// once; allowed any, it converges through them to an equilibrium and says what it is.
BOOST_AUTO_TEST_CASE(indefinite_tangents_are_refused_or_followed_as_asked) {
  const Settings settings{.law = Law::st_venant_kirchhoff, .element = Element::q1_sri};
  Problem problem(3, settings, -0.45, 0, 0);
  const NewtonResult refused = newton(problem.elasticity, problem.layers_moved(),
                                      problem.no_load, Tangents::definite);
  BOOST_TEST((refused.outcome == NewtonOutcome::indefinite));
  BOOST_TEST(!refused.definite);
  const NewtonResult followed =
      newton(problem.elasticity, problem.layers_moved(), problem.no_load, Tangents::any);
  BOOST_TEST((followed.outcome == NewtonOutcome::converged));
  BOOST_TEST(!followed.definite);
  BOOST_TEST(problem.elasticity.negative_eigenvalues().value() > 0);
}

// The plates have passed through each other. Small-strain Hooke's law does not mind.
BOOST_AUTO_TEST_CASE(inverted_states_are_told) {
  for (const Law law : laws)
    for (const Element element : elements)
      BOOST_TEST_CONTEXT(words(law) << ' ' << words(element)) {
        Problem problem(2, {.law = law, .element = element}, -1.2, 0);
        const NewtonResult result = newton(problem.elasticity, problem.layers_moved(),
                                           problem.no_load, Tangents::any);
        BOOST_TEST(result.internal.smallest_jacobian < 0);
        BOOST_TEST((result.outcome == (law == Law::hooke ? NewtonOutcome::converged
                                                         : NewtonOutcome::inverted)));
      }
}

BOOST_AUTO_TEST_CASE(numbers_that_are_none_do_not_converge) {
  for (const Law law : laws) {
    Problem problem(2, {.law = law, .element = Element::q1}, -0.1, 0);
    Eigen::VectorXd start = problem.layers_moved();
    start[40] = std::nan("");
    const NewtonResult result =
        newton(problem.elasticity, start, problem.no_load, Tangents::any);
    BOOST_TEST((result.outcome == NewtonOutcome::stalled));
  }
}

// Hencky's cube pulled at by dead loads far beyond what it bears: Newton gives up, and
// the last iterate is still a proper state.
BOOST_AUTO_TEST_CASE(hopeless_loads_stall) {
  Problem problem(2, {.law = Law::hencky, .element = Element::q1}, 0, 0);
  Eigen::VectorXd load = problem.no_load;
  for (Eigen::Index dof = 0; dof < load.size(); dof += 3) load[dof] = 1e3;  // N
  const NewtonResult result =
      newton(problem.elasticity, problem.layers_moved(), load, Tangents::any);
  BOOST_TEST((result.outcome == NewtonOutcome::stalled));
  BOOST_TEST(result.internal.smallest_jacobian > 0);
  BOOST_TEST(result.residual > 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
