#include "statics/equilibrium.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "fem_reference/statics/loads.hpp"
#include "tests/fem_reference/statics/log.hpp"
#include "tests/fem_reference/statics/problem.hpp"

using namespace springcheck;
using namespace springcheck::fem_reference;
using statics::Equilibrium;

BOOST_AUTO_TEST_SUITE(equilibrium_test)

namespace {

constexpr Settings st_venant{.law = Law::st_venant_kirchhoff, .element = Element::q1_sri};

bool contains(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

// The prediction from plates and weight is the answer: the only evaluations are those at
// rest and at the result.
BOOST_AUTO_TEST_CASE(hooke_takes_one_step_and_one_linear_solve) {
  for (const Element element : elements) {
    Problem problem(4, {.law = Law::hooke, .element = element}, 0.3, -0.5);
    problem.loading.forces = body_load(problem.body, [](const Vector3&) -> Vector3 {
      return {-1e4, 0, 0};
    });
    const Equilibrium found = problem.found();
    BOOST_TEST((found.status == SolveStatus::ok));
    BOOST_TEST(found.steps == 1);
    BOOST_TEST(found.force_evaluations == 2);
  }
}

// The first step is chosen by the strain: 5 % at once, 20 % begins with about a quarter.
BOOST_AUTO_TEST_CASE(steps_are_doubled_after_success) {
  BOOST_TEST(Problem(3, st_venant, 0.25, -0.05).found().steps == 1);
  const CapturedLog log;
  const Equilibrium found = Problem(3, st_venant, 0.25, -0.2).found();
  BOOST_TEST((found.status == SolveStatus::ok));
  const auto attempts = log.attempts();
  BOOST_TEST_REQUIRE(attempts.size() == 3U);
  BOOST_TEST(found.steps == 3);
  BOOST_TEST(std::abs(attempts[0].to - 0.27) < 0.03);
  BOOST_TEST(std::abs(attempts[1].to - 3 * attempts[0].to) < 2e-5);  // digits logged
  BOOST_TEST(attempts[2].to == 1);
}

// After a failure steps are of half the size as long as what failed is ahead. The
// smallest step is of 1/1024 of the load, and is tried twice: on stable states, then on
// any.
BOOST_AUTO_TEST_CASE(steps_are_halved_after_failure) {
  const CapturedLog log;
  const Equilibrium found = Problem(3, st_venant, 0.25, -1.1).found();
  double reached = 0, size = 0, failed_at = 2;
  bool failed = false;
  int failures = 0, successes = 0;
  for (const auto& [to, is_found] : log.attempts()) {
    const double wanted = to - reached;
    if (failed && size >= 2. / 1024)
      BOOST_TEST(std::abs(wanted - size / 2) < 3e-5);
    else if (failed_at < 2)
      BOOST_TEST(wanted <= size + 3e-5);
    size = wanted;
    failed = !is_found;
    failures += failed ? 1 : 0;
    successes += is_found ? 1 : 0;
    if (is_found) reached = to;
    if (failed)
      failed_at = to;
    else if (to >= failed_at)
      failed_at = 2;
  }
  BOOST_TEST(failures > 5);
  BOOST_TEST(successes == found.steps);
  BOOST_TEST(std::abs(reached - found.load_fraction) < 1e-5);
  BOOST_TEST(size >= 1. / 1024 - 1e-5);
  BOOST_TEST(size < 2. / 1024);
}

// A step begins with what the tangent predicts of it: what is left unbalanced is of
// second order in the step. The first one here strains by about 5 %; supports moved
// alone, or a load not in proportion, would leave 100 % and more.
BOOST_AUTO_TEST_CASE(steps_start_from_a_prediction) {
  for (const bool pulled : {false, true}) {
    const CapturedLog log;
    Problem problem(3, st_venant, 0.25, pulled ? 0 : -0.2);
    if (pulled)
      problem.loading.forces =
          traction_load(problem.body, {.region = "x_max", .stress = {0.2 * young, 0, 0}});
    const Equilibrium found = problem.found();
    BOOST_TEST(found.steps > 1);
    for (const auto& residuals : log.residuals()) BOOST_TEST(residuals.front() < 0.3);
  }
}

// The tolerance is Newton's 1e-10 times the body's condition.
BOOST_AUTO_TEST_CASE(steps_end_where_one_leap_would) {
  for (const Law law : {Law::st_venant_kirchhoff, Law::hencky, Law::cauchy_born}) {
    Problem problem(3, {.law = law, .element = Element::q1_sri}, 0.25, -0.2, 0.5);
    const Equilibrium found = problem.found();
    BOOST_TEST(found.steps > 1);
    const statics::Minimum leap =
        problem.minimum(problem.layers_moved(), statics::Tangents::definite);
    BOOST_TEST(leap.found);
    BOOST_TEST((found.displacements - leap.state.displacements).norm() <
               1e-8 * leap.state.displacements.norm());
  }
}

// dW/ds = sum r.du/ds: what the plates do is what the body stores. The errors of the
// differences are Newton's 1e-10 over the step of 1e-2 of the motion.
BOOST_AUTO_TEST_CASE(reactions_do_the_work_that_the_body_stores) {
  for (const Law law : laws)
    for (const Element element : elements)
      BOOST_TEST_CONTEXT(words(law) << ' ' << words(element)) {
        Problem problem(2, {.law = law, .element = element}, 0.4, -0.1, 0.2);
        const auto stored = [&](double d) {
          return scalar(
              problem.found([&](double s) { return s * (1 + d); }).strain_energy);
        };
        const Equilibrium found = problem.found();
        const Eigen::VectorXd rate = derivative(
            [&](double d) -> Eigen::VectorXd {
              return problem.supports.displacements(1 + d);
            },
            1e-2);
        const double work = found.reactions.dot(rate);
        BOOST_TEST(derivative(stored, 1e-2)[0] == work,
                   boost::test_tools::tolerance(1e-6));
        BOOST_TEST((problem.free_part(found.reactions).norm() == 0));
      }
}

// The load is followed in proportion, and balanced by the reactions.
BOOST_AUTO_TEST_CASE(reactions_balance_the_load) {
  for (const Law law : laws) {
    Problem problem(3, {.law = law, .element = Element::q1_sri}, 0.3, -0.1);
    problem.loading.forces = random_nodal(problem.body, 0.01);
    const Equilibrium found = problem.found();
    BOOST_TEST((found.status == SolveStatus::ok));
    BOOST_TEST((total(found.reactions) + total(problem.loading.forces)).norm() <
               1e-9 * problem.loading.forces.norm());
  }
}

// A path that ends half way, at a plate that is nowhere: the last state is in balance
// with the load in proportion to the fraction reached.
BOOST_AUTO_TEST_CASE(unfinished_paths_end_in_balance) {
  Problem problem(3, {.law = Law::hencky, .element = Element::q1_sri}, 0.3, -0.2);
  problem.loading.forces = body_load(problem.body, [](const Vector3&) -> Vector3 {
    return {2e4, 0, 0};
  });
  const Equilibrium found =
      problem.found([](double s) { return s < 0.6 ? s : std::nan(""); });
  BOOST_TEST((found.status == SolveStatus::not_converged));
  BOOST_TEST(found.load_fraction > 0.5);
  BOOST_TEST(found.load_fraction < 0.6);
  BOOST_TEST(
      (total(found.reactions) + found.load_fraction * total(problem.loading.forces))
          .norm() < 1e-9 * total(problem.loading.forces).norm());
}

// St-Venant's cube of nu = 0 has a symmetric equilibrium at 45 %, which is no minimum:
// its energy falls from there until a cell is inside out.
BOOST_AUTO_TEST_CASE(a_path_ends_where_it_loses_stability_and_no_minimum_is_near) {
  Problem problem(3, st_venant, 0, -0.45);
  const Equilibrium found = problem.found();
  BOOST_TEST((found.status == SolveStatus::no_equilibrium), found.reason);
  BOOST_TEST(contains(found.reason, "a cell turned inside out, the energy falling"));
  BOOST_TEST(found.load_fraction < 1);
  BOOST_TEST(found.definite_up_to.value() == found.load_fraction);

  // Up to there the state is a minimum, and 2/1024 of the load further none is found.
  const double at = found.load_fraction;
  for (const double factor : {0.5, 1., 1.01}) {
    const Equilibrium part =
        problem.found([&](double s) { return s * std::min(1., at * factor); });
    BOOST_TEST(
        (part.status == (factor > 1 ? SolveStatus::no_equilibrium : SolveStatus::ok)));
    BOOST_TEST(part.definite_up_to.has_value() == (factor > 1));
  }
}

// The continuum of mss-cf at nu = 0 loses its lateral minimum when pulled: at 19.5 %
// where nothing holds the sides.
BOOST_AUTO_TEST_CASE(limit_point_is_reported_with_the_load_reached) {
  const Settings lattice{.law = Law::cauchy_born, .element = Element::q1_sri};
  const Equilibrium found = Problem(4, lattice, 0, 0.5).found();
  BOOST_TEST((found.status == SolveStatus::no_equilibrium), found.reason);
  BOOST_TEST(found.load_fraction > 0.3);
  BOOST_TEST(found.load_fraction < 1);
  BOOST_TEST(contains(found.reason, "no equilibrium found beyond"));
  BOOST_TEST(found.definite_up_to.value() == found.load_fraction);

  // q2's, whose rate rises by less than half: the part that turns back is a small one.
  const Settings triquadratic{.law = Law::cauchy_born, .element = Element::q2};
  const Equilibrium small = Problem(3, triquadratic, 0, 0.25).found();
  BOOST_TEST((small.status == SolveStatus::no_equilibrium), small.reason);
}

// A whole turn ends where it began: only the way there tells it from rest.
BOOST_AUTO_TEST_CASE(a_turn_is_followed_along_its_way) {
  const Settings law{.law = Law::hencky, .element = Element::q1_sri};
  const double pi = std::numbers::pi;
  const Equilibrium half = Problem(2, law, 0.25, 0, pi / 2).found();
  const Equilibrium whole = Problem(2, law, 0.25, 0, 2 * pi).found();
  BOOST_TEST((half.status == SolveStatus::ok), half.reason);
  BOOST_TEST(
      (whole.status != SolveStatus::ok || whole.strain_energy > 2 * half.strain_energy));
}

// Beyond 302 degrees a search finds a state at 480 degrees that is another branch's;
// steps are of 1/1024 of the load.
BOOST_AUTO_TEST_CASE(a_turn_ends_where_the_path_does_whatever_the_load) {
  const Settings law{.law = Law::hencky, .element = Element::q1_sri};
  const auto degrees_reached = [&](double degrees) {
    const Equilibrium found =
        Problem(3, law, 0.4, 0, degrees * std::numbers::pi / 180).found();
    BOOST_TEST((found.status != SolveStatus::ok), found.reason);
    return degrees * found.load_fraction;
  };
  BOOST_TEST(degrees_reached(480) == degrees_reached(420),
             boost::test_tools::tolerance(.005));
}

// The plates are driven through each other. The last state is that of the fraction
// reached.
BOOST_AUTO_TEST_CASE(giving_up_names_the_load_reached_and_what_steps_end_with) {
  Problem problem(3, st_venant, 0.25, -1.1);
  const Equilibrium found = problem.found();
  BOOST_TEST((found.status == SolveStatus::not_converged), found.reason);
  BOOST_TEST(found.load_fraction > 0.3);
  BOOST_TEST(found.load_fraction < 0.4);
  char words[64];
  std::snprintf(words, sizeof words, "not converged beyond %.2f %% of the load",
                100 * found.load_fraction);
  BOOST_TEST(contains(found.reason, words), found.reason);
  BOOST_TEST(contains(found.reason, "a cell turned inside out"), found.reason);
  const Eigen::VectorXd off =
      found.displacements - problem.supports.displacements(found.load_fraction);
  BOOST_TEST((off - problem.free_part(off)).norm() == 0);
  BOOST_TEST(!found.definite_up_to.has_value());
}

// Twenty times its length: rounding keeps the residual of the thinned body above 1e-10 of
// the reactions, and below 1e-9.
BOOST_AUTO_TEST_CASE(a_residual_at_the_rounding_of_forces_is_one_of_an_equilibrium) {
  const Settings law{.law = Law::hencky, .element = Element::q1_sri};
  const Equilibrium found = Problem(4, law, 0.4, 20).found();
  BOOST_TEST((found.status == SolveStatus::ok), found.reason);
}

// A lattice with edge springs that push: C11 < C12 at rest.
BOOST_AUTO_TEST_CASE(body_indefinite_at_rest_is_told) {
  Problem problem(3,
                  {.law = Law::cauchy_born,
                   .element = Element::q1,
                   .lattice = {.springs = Springs::baudet}},
                  -0.4, -0.01);
  const Equilibrium found = problem.found();
  BOOST_TEST(found.definite_up_to.value() == 0);
}

BOOST_AUTO_TEST_CASE(motion_that_is_not_a_number_never_ends_ok) {
  for (const Law law : laws) {
    const Equilibrium found =
        Problem(2, {.law = law, .element = Element::q1_sri}, 0.3, std::nan("")).found();
    BOOST_TEST((found.status == SolveStatus::not_converged));
    BOOST_TEST(found.load_fraction == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
