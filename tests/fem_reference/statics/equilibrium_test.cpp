#include "fem_reference/statics/equilibrium.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "fem_reference/statics/loads.hpp"
#include "fem_reference/statics/newton.hpp"
#include "fem_reference/statics/supports.hpp"
#include "tests/fem_reference/bodies.hpp"
#include "tests/fem_reference/laws.hpp"
#include "tests/fem_reference/statics/log.hpp"

using namespace springcheck;
using namespace springcheck::fem_reference;

BOOST_AUTO_TEST_SUITE(equilibrium_test)

namespace {

constexpr Settings st_venant{.law = Law::st_venant_kirchhoff, .element = Element::q1_sri};

/// A cube between a fixed and a moved plate, and the way there: the plate's position as a
/// fraction of its motion, by load fraction.
struct Problem {
  Problem(int cells, const Settings& settings, double nu, double strain, double angle = 0)
      : mesh(cube(cells)),
        scene(between_plates(of_poisson_ratio(nu), {0, 0, strain * edge}, angle)),
        body(discretise(mesh, settings.element)),
        supports(mesh, scene, body),
        elasticity(body, scene.material, settings, supports.prescribed()),
        load(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * body.nodes.size()))) {}

  Equilibrium found(const std::function<double(double)>& way = [](double s) {
    return s;
  }) {
    return find_equilibrium(
        elasticity,
        {.displacements = [&](double s) { return supports.displacements(way(s)); },
         .forces = load,
         .follows_supports = [](const auto&, double) { return true; }});
  }
  Mesh mesh;
  Scene scene;
  Discretisation body;
  Supports supports;
  Elasticity elasticity;
  Eigen::VectorXd load;
};

bool contains(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

// The prediction from plates and weight is the answer: the only evaluations are those at
// rest and at the result.
BOOST_AUTO_TEST_CASE(hooke_takes_one_step_and_one_linear_solve) {
  for (const Element element : elements) {
    Problem problem(4, {.law = Law::hooke, .element = element}, 0.3, -0.5);
    problem.load = body_load(problem.body, [](const Vector3&) -> Vector3 {
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

// Half the size after a failure, the same after the success that follows. The smallest
// step is 1/1024 of the load.
BOOST_AUTO_TEST_CASE(steps_are_halved_after_failure) {
  const CapturedLog log;
  const Equilibrium found = Problem(3, st_venant, 0.25, -1.1).found();
  double reached = 0, size = 0;
  bool failed = false;
  int failures = 0, successes = 0;
  for (const auto& [to, converged] : log.attempts()) {
    const double wanted = to - reached;
    if (failed)
      BOOST_TEST(std::abs(wanted - size / 2) < 3e-5);
    else if (failures > 0 && successes > 1)
      BOOST_TEST(wanted <= 2 * size + 3e-5);
    size = wanted;
    failed = !converged;
    failures += failed ? 1 : 0;
    successes += converged ? 1 : 0;
    if (converged) reached = to;
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
      problem.load =
          traction_load(problem.body, {.region = "x_max", .stress = {0.2 * young, 0, 0}});
    const Equilibrium found = problem.found();
    BOOST_TEST(found.steps > 1);
    for (const auto& residuals : log.residuals()) BOOST_TEST(residuals.front() < 0.3);
  }
}

// Tolerance: Newton's 1e-10 times the body's condition.
BOOST_AUTO_TEST_CASE(steps_end_where_one_leap_would) {
  for (const Law law : {Law::st_venant_kirchhoff, Law::hencky, Law::cauchy_born}) {
    Problem problem(3, {.law = law, .element = Element::q1_sri}, 0.25, -0.2, 0.5);
    const Equilibrium found = problem.found();
    BOOST_TEST(found.steps > 1);
    const Eigen::VectorXd layers = nodal(problem.body, [&](const Vector3& X) {
      return displacement(problem.scene.plates[1].motion, {X.x(), X.y(), edge},
                          X.z() / edge);
    });
    const NewtonResult leap =
        newton(problem.elasticity, layers, problem.load, Tangents::definite);
    BOOST_TEST((leap.outcome == NewtonOutcome::converged));
    BOOST_TEST((found.displacements - leap.displacements).norm() <
               1e-8 * leap.displacements.norm());
  }
}

// dW/ds = sum r.du/ds: what the plates do is what the body stores. Errors of the
// differences: Newton's 1e-10 over the step of 1e-2 of the motion.
BOOST_AUTO_TEST_CASE(reactions_do_the_work_that_the_body_stores) {
  for (const Law law : laws)
    for (const Element element : elements)
      BOOST_TEST_CONTEXT(words(law) << ' ' << words(element)) {
        Problem problem(2, {.law = law, .element = element}, 0.4, -0.1, 0.2);
        const auto stored = [&](double d) {
          return scalar(problem.found([&](double s) { return s * (1 + d); }).energy);
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
        BOOST_TEST((problem.elasticity.free_part(found.reactions).norm() == 0));
      }
}

// The load is followed in proportion, and balanced by the reactions.
BOOST_AUTO_TEST_CASE(reactions_balance_the_load) {
  for (const Law law : laws) {
    Problem problem(3, {.law = law, .element = Element::q1_sri}, 0.3, -0.1);
    problem.load = random_nodal(problem.body, 0.01);
    const Equilibrium found = problem.found();
    BOOST_TEST((found.status == SolveStatus::ok));
    BOOST_TEST((total(found.reactions) + total(problem.load)).norm() <
               1e-9 * problem.load.norm());
  }
}

// A path that ends half way, at a plate that is nowhere: the last state is in balance
// with the load in proportion to the fraction reached.
BOOST_AUTO_TEST_CASE(unfinished_paths_end_in_balance) {
  Problem problem(3, {.law = Law::hencky, .element = Element::q1_sri}, 0.3, -0.2);
  problem.load = body_load(problem.body, [](const Vector3&) -> Vector3 {
    return {2e4, 0, 0};
  });
  const Equilibrium found =
      problem.found([](double s) { return s < 0.6 ? s : std::nan(""); });
  BOOST_TEST((found.status == SolveStatus::not_converged));
  BOOST_TEST(found.load_fraction > 0.5);
  BOOST_TEST(found.load_fraction < 0.6);
  BOOST_TEST((total(found.reactions) + found.load_fraction * total(problem.load)).norm() <
             1e-9 * total(problem.load).norm());
}

// St-Venant's cube of nu = 0 at 45 %: the state is an equilibrium, and no solution.
BOOST_AUTO_TEST_CASE(equilibrium_past_a_bifurcation_is_reported_indefinite) {
  Problem problem(3, st_venant, 0, -0.45);
  const Equilibrium found = problem.found();
  BOOST_TEST((found.status == SolveStatus::indefinite));
  BOOST_TEST(found.load_fraction == 1);
  BOOST_TEST_REQUIRE(found.definite_up_to.has_value());
  BOOST_TEST(*found.definite_up_to < 1);
  BOOST_TEST(contains(found.reason, "lost positive definiteness at"));

  // Where it says, the tangent is definite; 1/1024 of the load further it is not, nor is
  // it anywhere before that: the loss is found at the first place.
  const double at = *found.definite_up_to;
  for (const double factor : {0.5, 1., 1.01}) {
    const Equilibrium part =
        problem.found([&](double s) { return s * std::min(1., at * factor); });
    BOOST_TEST((part.status == (factor > 1 ? SolveStatus::indefinite : SolveStatus::ok)));
    BOOST_TEST(part.definite_up_to.has_value() == (factor > 1));
  }
}

// There and back: definite again at the end, and the reason remembers.
BOOST_AUTO_TEST_CASE(definiteness_regained_is_ok_and_remembered) {
  Problem problem(3, st_venant, 0, -0.45);
  const Equilibrium found =
      problem.found([](double s) { return s < 0.6 ? s / 0.6 : 1 - (s - 0.6); });
  BOOST_TEST((found.status == SolveStatus::ok), found.reason);
  BOOST_TEST(found.load_fraction == 1);
  const std::string words = "was not positive definite between ";
  BOOST_TEST_REQUIRE(contains(found.reason, words), found.reason);
  const std::string interval =
      found.reason.substr(found.reason.find(words) + words.size());
  double lost = 0, regained = 0;  // %
  BOOST_TEST(std::sscanf(interval.c_str(), "%lf %% and %lf %%", &lost, &regained) == 2);
  BOOST_TEST(lost < 60);
  BOOST_TEST(regained > 60);
  BOOST_TEST(regained < 90);
  BOOST_TEST_REQUIRE(found.definite_up_to.has_value());
  BOOST_TEST(*found.definite_up_to < 0.6);
  const Equilibrium straight = problem.found([](double s) { return 0.6 * s; });
  BOOST_TEST((found.displacements - straight.displacements).norm() <
             1e-8 * straight.displacements.norm());
}

// Once definiteness is regained, a failure is a failure again and no limit point.
BOOST_AUTO_TEST_CASE(failures_after_definiteness_is_regained_are_not_limit_points) {
  const Equilibrium found = Problem(3, st_venant, 0, -0.45).found([](double s) {
    if (s > 0.95) return std::nan("");
    return s < 0.6 ? s / 0.6 : 1 - (s - 0.6);
  });
  BOOST_TEST(found.load_fraction > 0.9);
  BOOST_TEST((found.status == SolveStatus::not_converged), found.reason);
  BOOST_TEST(contains(found.reason, "gave up"));
}

// The continuum of mss-cf at nu = 0 loses its lateral minimum when pulled: at 19.5 %
// where nothing holds the sides.
BOOST_AUTO_TEST_CASE(limit_point_is_reported_with_the_load_reached) {
  const Settings lattice{.law = Law::cauchy_born, .element = Element::q1_sri};
  const Equilibrium found = Problem(4, lattice, 0, 0.5).found();
  BOOST_TEST((found.status == SolveStatus::no_equilibrium), found.reason);
  BOOST_TEST(found.load_fraction > 0.3);
  BOOST_TEST(found.load_fraction < 1);
  BOOST_TEST(contains(found.reason, "limit point at"));
  BOOST_TEST(contains(found.reason, "loses positive definiteness at"));
  BOOST_TEST_REQUIRE(found.definite_up_to.has_value());
  BOOST_TEST(*found.definite_up_to <= found.load_fraction);

  // q2's, whose rate rises by less than half: the part that turns back is a small one.
  const Settings triquadratic{.law = Law::cauchy_born, .element = Element::q2};
  const Equilibrium small = Problem(3, triquadratic, 0, 0.25).found();
  BOOST_TEST((small.status == SolveStatus::no_equilibrium), small.reason);
}

// A plate that jumps: Newton's method fails on a path that is indefinite but steady.
BOOST_AUTO_TEST_CASE(a_failure_on_a_steady_indefinite_path_is_not_a_limit_point) {
  const Settings lattice{.law = Law::cauchy_born, .element = Element::q1_sri};
  for (const double jump : {1.1, 1.2, 1.3}) {
    const Equilibrium found = Problem(4, lattice, 0.25, -0.55).found([&](double s) {
      return s > 0.85 ? jump : s;
    });
    BOOST_TEST((found.status == SolveStatus::not_converged), found.reason);
    BOOST_TEST(found.load_fraction < 0.86);
    BOOST_TEST(contains(found.reason, "gave up"));
    BOOST_TEST(contains(found.reason, "did not converge"));
    BOOST_TEST_REQUIRE(found.definite_up_to.has_value());
    BOOST_TEST(*found.definite_up_to < 0.75);
  }
}

// The path ends where an element turns inside out: no sign of a limit point.
BOOST_AUTO_TEST_CASE(a_path_that_ends_in_inversion_is_not_converged) {
  const Equilibrium found = Problem(4, st_venant, 0.25, -0.6).found();
  BOOST_TEST((found.status == SolveStatus::not_converged), found.reason);
  BOOST_TEST(contains(found.reason, "turned a cell inside out"));
  BOOST_TEST_REQUIRE(found.definite_up_to.has_value());
  BOOST_TEST(std::abs(*found.definite_up_to * 0.6 - 0.33) < 0.01);
}

// A whole turn ends where it began: only the way there tells it from rest.
BOOST_AUTO_TEST_CASE(a_turn_is_followed_along_its_way) {
  const Settings law{.law = Law::hencky, .element = Element::q1_sri};
  const double pi = std::numbers::pi;
  const Equilibrium half = Problem(2, law, 0.25, 0, pi / 2).found();
  const Equilibrium whole = Problem(2, law, 0.25, 0, 2 * pi).found();
  BOOST_TEST((half.status == SolveStatus::ok), half.reason);
  BOOST_TEST((whole.status != SolveStatus::ok || whole.energy > 2 * half.energy));
}

// Beyond 302 degrees Newton's method with indefinite tangents finds a state at 480
// degrees that is another branch's; steps are of 1/1024 of the load.
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

// Plates driven through each other. The reason names how far, the last residual and the
// smallest det F; the last state is that of the fraction reached.
BOOST_AUTO_TEST_CASE(giving_up_names_the_load_reached_the_residual_and_the_jacobian) {
  Problem problem(3, st_venant, 0.25, -1.1);
  const Equilibrium found = problem.found();
  BOOST_TEST((found.status == SolveStatus::not_converged));
  BOOST_TEST(found.load_fraction > 0.3);
  BOOST_TEST(found.load_fraction < 0.4);
  char words[64];
  std::snprintf(words, sizeof words, "gave up at %.2f %% of the load",
                100 * found.load_fraction);
  BOOST_TEST(contains(found.reason, words), found.reason);
  BOOST_TEST(contains(found.reason, "turned a cell inside out"), found.reason);
  BOOST_TEST(contains(found.reason, "relative residual "), found.reason);
  BOOST_TEST(contains(found.reason, "smallest det F -0.0"), found.reason);
  const Eigen::VectorXd off =
      found.displacements - problem.supports.displacements(found.load_fraction);
  BOOST_TEST((off - problem.elasticity.free_part(off)).norm() == 0);
  BOOST_TEST(!found.definite_up_to.has_value());
}

// A lattice with edge springs that push: C11 < C12 at rest.
BOOST_AUTO_TEST_CASE(body_indefinite_at_rest_is_told) {
  Problem problem(3,
                  {.law = Law::cauchy_born,
                   .element = Element::q1,
                   .lattice = {.springs = Springs::baudet}},
                  -0.4, -0.01);
  const Equilibrium found = problem.found();
  BOOST_TEST((found.status == SolveStatus::indefinite));
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
