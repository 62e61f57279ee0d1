#include "statics/minimum.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>

#include "fem_reference/statics/loads.hpp"
#include "tests/fem_reference/statics/log.hpp"
#include "tests/fem_reference/statics/problem.hpp"

// The search for minima, on elements.

using namespace springcheck;
using namespace springcheck::fem_reference;
using statics::Minimum, statics::Tangents;

BOOST_AUTO_TEST_SUITE(minimum_test)

// r_(k+1) <= C r_k^2 below 1e-2 and above round-off, with C below 3 at the strains of 10,
// 20 and 80 % here; the log shows it. A tangent 1 % wrong would end the series at
// r_(k+1) = .01 r_k.
BOOST_AUTO_TEST_CASE(residual_falls_quadratically) {
  for (const Law law : {Law::st_venant_kirchhoff, Law::hencky, Law::cauchy_born})
    for (const Element element : elements)
      for (const double strain : {-0.1, -0.2, 0.8})
        BOOST_TEST_CONTEXT(words(law) << ' ' << words(element) << ", strain " << strain) {
          Problem problem(3, {.law = law, .element = element}, 0.25, strain, 0.3);
          const CapturedLog log;
          const Minimum found =
              problem.minimum(problem.layers_moved(), Tangents::definite);
          BOOST_TEST(found.found);
          BOOST_TEST(found.definite);
          BOOST_TEST(!found.crossed);
          BOOST_TEST(found.residual < 1e-10);
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
    Problem problem(3, {.law = Law::hooke, .element = element}, 0.25, -0.3, 0.3);
    const Minimum found = problem.minimum(problem.only_plates_moved());
    BOOST_TEST(found.found);
    BOOST_TEST(found.iterations == 1);
    BOOST_TEST(found.residual < 1e-13);
  }
}

// Where only the plates have moved, full steps turn cells inside out: without halving
// there is no way on.
BOOST_AUTO_TEST_CASE(line_search_leads_back_to_the_solution) {
  Problem problem(3, {.law = Law::hencky, .element = Element::q2}, 0.25, -0.05, 0.8);
  const Eigen::VectorXd start = problem.only_plates_moved();
  const Minimum found = problem.minimum(start);
  BOOST_TEST(found.found);
  BOOST_TEST(found.state.strain_energy < problem.elements.state(start).strain_energy);
  const Minimum direct = problem.minimum(problem.layers_moved(), Tangents::definite);
  BOOST_TEST((found.state.displacements - direct.state.displacements).norm() <
             1e-8 * direct.state.displacements.norm());
}

// A nearly incompressible body under dead loads: on the way there are states where every
// part of Newton's step raises the residual, and only the falling energy leads on.
BOOST_AUTO_TEST_CASE(energy_leads_where_the_residual_rises) {
  Problem problem(2, {.law = Law::hencky, .element = Element::q1_sri}, 0.499, 0);
  problem.loading.forces = problem.free_part(random_nodal(problem.body, 1));
  const CapturedLog log;
  const Minimum found = problem.minimum(problem.only_plates_moved());
  BOOST_TEST(found.found);
  const std::vector<double> r = log.residuals().front();
  BOOST_TEST(!std::ranges::is_sorted(r, std::ranges::greater()));
  BOOST_TEST(found.state.energy < 0);
}

// Equal and opposite pulls on a body that is only kept from moving rigidly: there are no
// reactions to measure the residual by, but a load.
BOOST_AUTO_TEST_CASE(balanced_loads_without_reactions_converge) {
  Problem problem(2, {.law = Law::hencky, .element = Element::q1_sri}, 0.25, 0);
  const Scene pinned{
      .material = problem.scene.material,
      .plates = {},
      .pins = {{.point = Vector3::Zero(), .held = {true, true, true}},
               {.point = Vector3(edge, 0, 0), .held = {false, true, true}},
               {.point = Vector3(0, edge, 0), .held = {false, false, true}}},
      .gravity = Vector3::Zero()};
  const Supports supports(problem.mesh, pinned, problem.body);
  problem.loading.is_free = supports.is_free();
  problem.loading.forces =
      traction_load(problem.body, {.region = "x_max", .stress = {0.1 * young, 0, 0}}) +
      traction_load(problem.body, {.region = "x_min", .stress = {-0.1 * young, 0, 0}});
  const Minimum found =
      problem.minimum(Eigen::VectorXd::Zero(problem.loading.forces.size()));
  BOOST_TEST(found.found);
  BOOST_TEST(found.residual < 1e-10);
  BOOST_TEST(problem.free_part(found.state.forces).norm() <
             1e-10 * problem.loading.forces.norm());
}

// Forces that balance the load to 1e-10, prescribed entries as they were; the state is
// the body's own.
BOOST_AUTO_TEST_CASE(result_is_in_balance_with_the_load_on_its_supports) {
  Problem problem(3, {.law = Law::hencky, .element = Element::q1_sri}, 0.25, 0.1);
  problem.loading.forces = random_nodal(problem.body, 0.02);  // N
  const Eigen::VectorXd start = problem.layers_moved(), &load = problem.loading.forces;
  const Minimum found = problem.minimum(start);
  BOOST_TEST(found.found);
  const auto state = problem.elements.state(found.state.displacements);
  BOOST_TEST(state.strain_energy == found.state.strain_energy);
  const Eigen::VectorXd all = load + state.forces, unbalanced = problem.free_part(all);
  BOOST_TEST(unbalanced.norm() <
             1e-10 * std::max((all - unbalanced).norm(), load.norm()));
  const Eigen::VectorXd moved = found.state.displacements - start;
  BOOST_TEST((moved - problem.free_part(moved)).norm() == 0);
}

// St-Venant's cube is indefinite at 45 %. Asked for definite tangents, the search ends at
// once; allowed any, it falls until cells are inside out.
BOOST_AUTO_TEST_CASE(indefinite_tangents_are_refused_or_gone_on_from_as_asked) {
  const Settings settings{.law = Law::st_venant_kirchhoff, .element = Element::q1_sri};
  Problem problem(3, settings, 0, -0.45);
  const Eigen::VectorXd start = problem.layers_moved();
  const Minimum refused = problem.minimum(start, Tangents::definite);
  BOOST_TEST(!refused.found);
  BOOST_TEST(refused.crossed);
  BOOST_TEST(refused.iterations == 0);
  const Minimum followed = problem.minimum(start);
  BOOST_TEST(!followed.found);
  BOOST_TEST(followed.crossed);
  BOOST_TEST(followed.inverted);
  BOOST_TEST(followed.state.energy < refused.state.energy);
}

// The plates have passed through each other. Small-strain Hooke's law does not mind.
BOOST_AUTO_TEST_CASE(inverted_states_are_told) {
  for (const Law law : laws)
    for (const Element element : elements)
      BOOST_TEST_CONTEXT(words(law) << ' ' << words(element)) {
        Problem problem(2, {.law = law, .element = element}, 0.25, -1.2);
        const Minimum found = problem.minimum(problem.layers_moved());
        BOOST_TEST(found.found == (law == Law::hooke));
        BOOST_TEST(found.inverted == (law != Law::hooke));
      }
}

BOOST_AUTO_TEST_CASE(numbers_that_are_none_do_not_converge) {
  for (const Law law : laws) {
    Problem problem(2, {.law = law, .element = Element::q1}, 0.25, -0.1);
    Eigen::VectorXd start = problem.layers_moved();
    start[40] = std::nan("");
    BOOST_TEST(!problem.minimum(start).found);
  }
}

// Hencky's cube is pulled at by dead loads far beyond what it bears.
BOOST_AUTO_TEST_CASE(hopeless_loads_run_away) {
  Problem problem(2, {.law = Law::hencky, .element = Element::q1}, 0.25, 0);
  for (Eigen::Index dof = 0; dof < problem.loading.forces.size(); dof += 3)
    problem.loading.forces[dof] = 1e3;  // N
  const Minimum found = problem.minimum(problem.layers_moved());
  BOOST_TEST(!found.found);
  BOOST_TEST(found.ran_away);
  BOOST_TEST(std::isfinite(found.state.energy));
}

BOOST_AUTO_TEST_SUITE_END()
