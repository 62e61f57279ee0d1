#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "comparisons/running/simulate.hpp"
#include "comparisons/settings/case_json.hpp"
#include "tests/comparisons/settings.hpp"

// The methods fem-explicit-1p and fem-explicit-8p, from settings to measures.

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(explicit_elements_test)

namespace {

CaseSettings explicit_case(std::vector<std::string> changes) {
  changes.insert(changes.begin(),
                 {"method=fem-explicit-8p", "cells=3,3,3", "duration=1"});
  return case_of("compression", changes);
}

CaseResult simulated(const CaseSettings& settings) {
  return simulate(settings, build_mesh(settings.body));
}

}  // namespace

BOOST_AUTO_TEST_CASE(they_step_by_semi_implicit_euler_unless_another_is_named) {
  const CaseSettings open = explicit_case({});
  BOOST_TEST((solver_of(open) == Solver::semi_implicit_euler));
  BOOST_TEST(label(open) == "fem-explicit-8p");
  const auto json = settings_json(open);
  BOOST_TEST(json["solver"] == "semi-implicit");
  BOOST_TEST(json["precision"] == "double");
  BOOST_TEST(json["damping"] == 0.05);
  BOOST_TEST(!json.contains("element"));
  BOOST_TEST(settings_json(explicit_case({"solver=verlet"}))["solver"] == "verlet");
}

BOOST_AUTO_TEST_CASE(what_they_cannot_do_is_refused_with_a_reason) {
  const auto without_duration = [](const char* change) {
    return case_of("compression", {"method=fem-explicit-8p", "cells=3,3,3", change});
  };
  for (const auto& [change, reason] :
       {std::pair{"solver=static", "fem-stvk has the static solver"},
        {"solver=implicit", "step explicitly"},
        {"cell-type=tetrahedron", "fem-explicit-stvk"}}) {
    const CaseResult result = simulated(without_duration(change));
    BOOST_TEST((result.status == Status::refused), change);
    BOOST_TEST(result.reason.find(reason) != std::string::npos, result.reason);
  }
}

// A history's last torque is the solution's, on the lever arms of the law.
BOOST_AUTO_TEST_CASE(histories_have_the_torques_of_the_end,
                     *boost::unit_test::tolerance(1e-12)) {
  for (const char* method : {"method=fem-explicit-hooke", "method=fem-explicit-hencky"}) {
    const CaseResult result = simulated(
        case_of("torsion", {method, "element=q1-nodal", "cell-type=tetrahedron",
                            "cells=2,2,2", "duration=.2", "deformation=1", "history=2"}));
    BOOST_TEST((result.status == Status::ok), result.reason);
    BOOST_TEST_REQUIRE(!result.history.empty());
    const auto torque_z =
        std::ranges::find(history_columns, "torque_z") - history_columns.begin();
    BOOST_TEST(result.history.back()[static_cast<std::size_t>(torque_z)] ==
                   *result.measures.plate_torque,
               method);
  }
}

// With this drag the plate's force is .2 % off the equilibrium's after 5 s (measured).
BOOST_AUTO_TEST_CASE(their_measures_are_those_of_the_static_element,
                     *boost::unit_test::tolerance(5e-3)) {
  const CaseResult moved = simulated(explicit_case({"duration=5", "damping=.2"}));
  const CaseResult rest =
      simulated(case_of("compression", {"method=fem-stvk", "element=q1", "cells=3,3,3"}));
  BOOST_TEST((moved.status == Status::ok), moved.reason);
  BOOST_TEST(*moved.measures.plate_force == *rest.measures.plate_force);
  BOOST_TEST(*moved.measures.volume_error == *rest.measures.volume_error);
}

BOOST_AUTO_TEST_SUITE_END()
