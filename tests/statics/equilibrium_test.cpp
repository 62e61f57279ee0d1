#include "statics/equilibrium.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

#include "statics/last_stable_equilibrium.hpp"
#include "statics/path_limit.hpp"
#include "tests/statics/analytic_body.hpp"

// Paths of a body whose energy is known in closed form.

using namespace springcheck;
using namespace springcheck::statics;

BOOST_AUTO_TEST_SUITE(equilibrium_test)

namespace {

constexpr LinearSolver both_kinds[] = {LinearSolver::direct,
                                       LinearSolver::conjugate_gradients};
const auto round_off = boost::test_tools::tolerance(1e-9);

PathLimit limit_of(const Potential& potential, double force) {
  AnalyticBody body(potential);
  const Loading loading = pulled(force);
  PotentialEnergy energy(body, loading, LinearSolver::direct);
  return follow_to_limit(energy, 1e-4,
                         [](const Eigen::VectorXd&, double) { return true; });
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_state_before_a_limit_point_is_that_of_the_closed_form) {
  for (const LinearSolver solver : both_kinds) {
    AnalyticBody body(with_limit_point(.25));  // up to 1 N at 2 m
    const Equilibrium found =
        find_equilibrium(body, pulled(.75), {.linear_solver = solver});
    BOOST_TEST((found.status == SolveStatus::ok), found.reason);
    BOOST_TEST(found.displacements[5] == 1, round_off);  // 1 - 1/4 N
    BOOST_TEST(found.reactions[2] == -.75, round_off);
    BOOST_TEST(found.strain_energy == 1. / 2 - 1. / 12, round_off);
    BOOST_TEST(!found.definite_up_to.has_value());
    BOOST_TEST(found.reactions.tail<3>().isZero(0));
  }
}

// Steps of the load go down to 1/1024, from less than twice that.
BOOST_AUTO_TEST_CASE(beyond_a_limit_point_there_is_no_equilibrium) {
  for (const LinearSolver solver : both_kinds) {
    AnalyticBody body(with_limit_point(.25));
    const Equilibrium found =
        find_equilibrium(body, pulled(1.25), {.linear_solver = solver});
    BOOST_TEST((found.status == SolveStatus::no_equilibrium), found.reason);
    BOOST_TEST(found.reason.find("the energy still falling") != std::string::npos);
    BOOST_TEST(found.load_fraction <= .8);
    BOOST_TEST(found.load_fraction > .8 - 2. / 1024);
    BOOST_TEST(found.definite_up_to.value() == found.load_fraction);
  }
}

// Long steps come to the minimum beyond, by definite tangents alone; unloaded it does not
// lead back.
BOOST_AUTO_TEST_CASE(a_jump_to_another_branch_does_not_count) {
  const double largest = 1 / std::sqrt(6), top = 1 - largest,
               limit = top * (top * top - 3 * top + 2.5);
  for (const LinearSolver solver : both_kinds)
    for (const double force : {.7, 1., 3., 20.}) {
      AnalyticBody body(with_snap());
      const Equilibrium found =
          find_equilibrium(body, pulled(force), {.linear_solver = solver});
      BOOST_TEST((found.status == SolveStatus::no_equilibrium), found.reason);
      BOOST_TEST(found.reason.find("another branch") != std::string::npos, found.reason);
      BOOST_TEST(found.load_fraction <= limit / force);
      BOOST_TEST(found.load_fraction > limit / force - 2. / 1024);
    }
  AnalyticBody body(with_snap());
  BOOST_TEST((find_equilibrium(body, pulled(.63), {}).status == SolveStatus::ok));
}

// The path goes on in one of two minima of the same energy; the seed says in which.
BOOST_AUTO_TEST_CASE(behind_a_bifurcation_the_path_goes_on_in_a_minimum) {
  std::set<bool> sides;
  for (const LinearSolver solver : both_kinds)
    for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
      AnalyticBody body(with_bifurcation());
      const Equilibrium found =
          find_equilibrium(body, pulled(1.5), {.linear_solver = solver, .seed = seed});
      BOOST_TEST((found.status == SolveStatus::ok), found.reason);
      BOOST_TEST(found.reason.find("the path may branch between") == 0U, found.reason);
      BOOST_TEST(std::abs(found.displacements[3]) == 1, round_off);
      BOOST_TEST(found.displacements[5] == 2, round_off);
      sides.insert(found.displacements[3] > 0);
    }
  BOOST_TEST(sides.size() == 2U);
}

// A barrier of .126 m and 1e-5 J is between the minimum under .999 N and none.
BOOST_AUTO_TEST_CASE(a_noise_leaves_what_is_hardly_a_minimum) {
  int left = 0;
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    AnalyticBody body(with_limit_point(.25));
    const Equilibrium stays =
        find_equilibrium(body, pulled(.75), {.seed = seed, .noise = .1});
    BOOST_TEST((stays.status == SolveStatus::ok), stays.reason);
    BOOST_TEST(stays.displacements[5] == 1, round_off);
    const Equilibrium found =
        find_equilibrium(body, pulled(.999), {.seed = seed, .noise = .5});
    if (found.status == SolveStatus::ok) continue;
    ++left;
    BOOST_TEST((found.status == SolveStatus::no_equilibrium), found.reason);
    BOOST_TEST(found.reason.find("a noise of 0.5 cell edges") == 0U, found.reason);
    BOOST_TEST(found.load_fraction == 1);
  }
  BOOST_TEST(left > 0);
  BOOST_TEST(left < 6);
}

// Where supports are elsewhere than the body shows, its minima do not count.
BOOST_AUTO_TEST_CASE(states_that_do_not_follow_their_supports_end_the_path) {
  AnalyticBody body(with_limit_point(.25));
  Loading loading = pulled(.75);
  loading.follows_supports = [](const Eigen::VectorXd& u, double) { return u[5] < .5; };
  const Equilibrium found = find_equilibrium(body, loading, {});
  BOOST_TEST((found.status == SolveStatus::no_equilibrium), found.reason);
  BOOST_TEST(found.reason.find("not turned as its plates are") != std::string::npos);
  const double reached = (.5 - .25 * .25) / .75;
  BOOST_TEST(found.load_fraction <= reached);
  BOOST_TEST(found.load_fraction > reached - 2. / 1024);
}

// The loads are found to the resolution asked for.
BOOST_AUTO_TEST_CASE(a_limit_point_and_a_bifurcation_are_told_apart) {
  const PathLimit turns_back = limit_of(with_limit_point(.25), 1.25);
  BOOST_TEST((turns_back.end == PathEnd::limit_point));
  BOOST_TEST(turns_back.load_fraction == .8, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(std::abs(turns_back.critical_mode[5]) == 1, round_off);
  BOOST_TEST(turns_back.mode_rest_curvature == 1, round_off);
  // 1 - 2 c z at z = (1 - sqrt(1 - 4 c p))/(2 c)
  BOOST_TEST(turns_back.curvature == std::sqrt(1 - 1.25 * turns_back.load_fraction),
             boost::test_tools::tolerance(1e-6));

  const PathLimit branches = limit_of(with_bifurcation(), 1.5);
  BOOST_TEST((branches.end == PathEnd::bifurcation));
  BOOST_TEST(branches.load_fraction == 2. / 3, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(branches.load_fraction < 2. / 3);
  BOOST_TEST(std::abs(branches.critical_mode[3]) == 1, round_off);
  BOOST_TEST(branches.curvature == 1 - 1.5 * branches.load_fraction,
             boost::test_tools::tolerance(1e-6));

  const PathLimit whole = limit_of(with_bifurcation(), .9);
  BOOST_TEST((whole.end == PathEnd::full_load));
  BOOST_TEST(whole.load_fraction == 1);
  BOOST_TEST(whole.state.displacements[5] == .9, round_off);
}

// The energy's shape at rest is that of a body without stability.
BOOST_AUTO_TEST_CASE(a_body_unstable_at_rest_has_no_path) {
  Potential potential = with_bifurcation();
  const auto energy = potential.energy;
  const auto gradient = potential.gradient;
  const auto hessian = potential.hessian;
  const Vector3 shift(0, 0, 1.25);
  potential.energy = [=](const Vector3& w) { return energy(w + shift) - 1.25 * w.z(); };
  potential.gradient = [=](const Vector3& w) -> Vector3 {
    return gradient(w + shift) - shift;
  };
  potential.hessian = [=](const Vector3& w) -> Matrix3 { return hessian(w + shift); };
  const PathLimit limit = limit_of(potential, .1);
  BOOST_TEST((limit.end == PathEnd::bifurcation));
  BOOST_TEST(limit.load_fraction == 0);
  BOOST_TEST(std::abs(limit.critical_mode[3]) == 1, round_off);
}

BOOST_AUTO_TEST_SUITE_END()
