#pragma once

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>

#include "dynamics/marching/march.hpp"

namespace springcheck::dynamics {

/// The real thing: 1000 steps of 98 % of the largest stable one end with displacements
/// below a bound [m], and steps of 102 % are found to be unstable: out of all bounds, or
/// turned round from step to step. `run` makes a Solution by a Protocol.
template <class Run>
void expect_stability_up_to(double limit, Integrator integrator, double bound,
                            const Run& run) {
  const auto by_steps_of = [&](double fraction) -> Solution {
    return run(Protocol{.integrator = integrator,
                        .duration = 1000 * fraction * limit,
                        .time_step = fraction * limit,
                        .force_time_step = true});
  };
  const Solution below = by_steps_of(0.98), above = by_steps_of(1.02);
  BOOST_TEST((below.status == SolveStatus::ok), below.reason);
  BOOST_TEST(below.steps == 1000);
  double largest = 0;
  for (const Vector3& u : below.displacements) largest = std::max(largest, u.norm());
  BOOST_TEST(largest < bound);
  BOOST_TEST((above.status == SolveStatus::diverged));
  BOOST_TEST(
      above.reason.find("by step " + std::to_string(above.steps)) != std::string::npos,
      above.reason);
}

}  // namespace springcheck::dynamics
