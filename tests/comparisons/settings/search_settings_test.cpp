// What springs and finite elements are searched with, and what they are held against.

#include <boost/test/unit_test.hpp>

#include "comparisons/methods/protocol.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(search_settings_test)

// Finite elements do not take the solver that the case names either; springs take what
// the case has.
BOOST_AUTO_TEST_CASE(elements_that_a_case_is_held_against_have_no_noise) {
  const auto reference = [](const std::string& name) {
    return requests(run_of("compression", {"method=mss-nfd", "reference=" + name,
                                           "noise=.1", "seed=7", "linear-solver=direct"}))
        .front()
        .reference.value();
  };
  const CaseSettings elements = reference("fem-stvk");
  BOOST_TEST(elements.search.noise == 0);
  BOOST_TEST(elements.search.seed == 1U);
  BOOST_TEST((elements.search.linear_solver == statics::LinearSolver::direct));
  const auto in_motion =
      requests(run_of("compression", {"method=mss-cf", "reference=fem-stvk",
                                      "solver=verlet", "duration=1", "damping=.1"}));
  BOOST_TEST(reference_label(in_motion.front()) == "fem-stvk:q1-sri");
  BOOST_TEST(reference("mss-cf").search.noise == .1);
  BOOST_TEST(reference("mss-cf").search.seed == 7U);
  const auto beside_a_limit = requests(
      run_of("compression", {"method=mss-cf", "reference=fem-stvk", "solver=limit"}));
  BOOST_TEST(!beside_a_limit.front().reference.has_value());
}

BOOST_AUTO_TEST_CASE(every_key_of_searches_reaches_springs_and_finite_elements) {
  for (const std::string method : {"method=mss-cf", "method=fem-stvk"}) {
    const CaseSettings settings =
        case_of("compression", {method, "noise=.1", "seed=7", "linear-solver=multigrid"});
    const statics::Search search = search_of(settings);
    BOOST_TEST(search.noise == .1);
    BOOST_TEST(search.seed == 7U);
    BOOST_TEST((search.linear_solver == statics::LinearSolver::multigrid));
    BOOST_TEST(!search.to_limit);
    BOOST_TEST(search_of(case_of("compression", {method, "solver=limit"})).to_limit);
  }
}

BOOST_AUTO_TEST_SUITE_END()
