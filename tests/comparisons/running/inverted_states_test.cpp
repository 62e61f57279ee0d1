#include <boost/test/unit_test.hpp>

#include "comparisons/running/simulate.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(inverted_states_test)

// A motion carries cells through the state of no volume. Their springs have no finite
// energy there: that is no overflow, and the other measures stay.
BOOST_AUTO_TEST_CASE(a_state_without_finite_energy_is_inverted) {
  const CaseSettings settings =
      case_of("compression", {"method=mss-affine-hencky", "cells=3,3,3",
                              "deformation=.97", "solver=semi-implicit", "duration=.2"});
  const CaseResult result = simulate(settings, build_mesh(settings.body));
  BOOST_TEST((result.status == Status::inverted), result.reason);
  BOOST_TEST(result.reason.find("inside out") != std::string::npos);
  BOOST_TEST(!result.measures.strain_energy.has_value());
  BOOST_TEST(*result.measures.corner_jacobian_ratio_min < 0);
}

BOOST_AUTO_TEST_SUITE_END()
