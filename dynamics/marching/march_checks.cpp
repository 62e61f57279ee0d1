#include "dynamics/marching/march_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace springcheck::dynamics {

double body_size(const std::vector<Vector3>& nodes) {
  Vector3 low = nodes.front(), high = low;
  for (const Vector3& x : nodes) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).norm();
}

double longest(const std::vector<Vector3>& vectors) {
  double square = 0;
  for (const Vector3& v : vectors) {
    if (!v.allFinite()) return std::numeric_limits<double>::infinity();
    square = std::max(square, v.squaredNorm());
  }
  return std::sqrt(square);
}

double alternation(std::span<const double> masses, const std::vector<Vector3>& before,
                   const std::vector<Vector3>& now) {
  double product = 0, squares = 0;
  for (std::size_t n = 0; n < masses.size(); ++n) {
    product += masses[n] * before[n].dot(now[n]);
    squares += masses[n] * (before[n].squaredNorm() + now[n].squaredNorm()) / 2;
  }
  return squares > 0 ? -product / squares : 0;
}

std::string reason_to_refuse(const MarchedBody& body, const Protocol& protocol,
                             double limit, bool is_anything_free) {
  const double wanted = protocol.time_step.value_or(protocol.step_ratio * limit);
  if (limit == 0 && !(protocol.time_step && protocol.force_time_step))
    return fmt::format(
        "explicit Euler is stable with no step: {}. semi-implicit and verlet are stable "
        "without; --dt with --force-dt runs it all the same",
        body.undamped);
  if (protocol.time_step && wanted > limit && !protocol.force_time_step)
    return fmt::format(
        "dt = {:.4g} s is above the stability limit {:.4g} s ({}); force-dt runs it all "
        "the same",
        wanted, limit, body.step_setters);
  if (std::isinf(wanted) && is_anything_free)
    return protocol.integrator == Integrator::implicit_euler
               ? "implicit Euler is stable with every step: name one by dt, auto has "
                 "none to choose"
               : "dt = auto has no swing to go by: no motion about the rest state has a "
                 "positive stiffness";
  if (!(protocol.duration / wanted < std::numeric_limits<int>::max()))
    return fmt::format("dt = {:.4g} s needs {:.3g} steps, more than can be counted",
                       wanted, protocol.duration / wanted);
  return {};
}

std::string above_limit(const MarchedBody& body, const Protocol& protocol,
                        const Excess& excess) {
  const auto& [step, dt, limit] = excess;
  const std::string when = protocol.time_step ? fmt::format("from step {} on", step)
                                              : fmt::format("at step {}", step);
  if (limit == 0)
    return fmt::format("explicit Euler is stable with no step {}: {}", when,
                       body.undamped);
  return fmt::format("dt = {:.4g} s is above the limit {:.4g} s of the {} {}", dt, limit,
                     step == 0 ? "body at rest" : "strained body", when);
}

}  // namespace springcheck::dynamics
