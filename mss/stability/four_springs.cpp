#include "mss/stability/four_springs.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "mss/forces/forces.hpp"
#include "mss/forces/tangent.hpp"

namespace springcheck::mss {
namespace {

enum Node : NodeIndex { A, B, C, D, E };

std::vector<Vector3> positions(const FourSprings& system, double x, double zeta) {
  const double l = system.length;
  return {{0, zeta * l, 0}, {0, -zeta * l, 0}, {x, 0, 0}, {-l, 0, 0}, {l, 0, 0}};
}

/// The last place at which `holds` is true on the way from `from`, where it is, to `to`,
/// where it is not.
template <class Holds>
double last_place(double from, double to, double tolerance, const Holds& holds) {
  while (std::abs(to - from) > tolerance) {
    const double middle = (from + to) / 2;
    (holds(middle) ? from : to) = middle;
  }
  return from;
}

}  // namespace

Network network_of(const FourSprings& system) {
  const double k = system.stiffness, l = system.length;
  Network network{.rest_positions = positions(system, 0, 1)};
  std::vector<CellSpring> springs;
  for (const Node end : {A, B, D, E}) {
    network.springs.push_back({.a = end, .b = C, .stiffness = k, .rest_length = l});
    const Vector3 rest = network.rest_positions[C] - network.rest_positions[end];
    springs.push_back({.ends = {end, C}, .stiffness = k, .rest = rest});
  }
  // A cell of springs alone, for the tangent: without a modulus its volume does nothing.
  const std::array<NodeIndex, 5> nodes{A, B, C, D, E};
  std::array<Vector3, 5> gradients;
  gradients.fill(Vector3::Zero());
  network.cells.add(nodes, gradients, l * l * l, springs);
  return network;
}

FourSpringForces forces_at(const FourSprings& system, double x, double zeta) {
  std::vector<Vector3> forces(5);
  nodal_forces(network_of(system), positions(system, x, zeta), forces);
  return {.centre = forces[C].x(), .top = forces[A].y()};
}

double stiffness_of_centre(const FourSprings& system, double zeta) {
  const Network network = network_of(system);
  const Eigen::MatrixXd K = part(tangent_at(network, positions(system, 0, zeta)), 0);
  return K(3 * C, 3 * C);
}

double bifurcation(const FourSprings& system) {
  return last_place(1, 0.1, 1e-15,
                    [&](double zeta) { return stiffness_of_centre(system, zeta) > 0; });
}

double centre_at_rest(const FourSprings& system, double zeta) {
  if (zeta != 0 && stiffness_of_centre(system, zeta) >= 0) return 0;
  const double l = system.length;
  return last_place(0, l, 1e-14 * l,
                    [&](double x) { return forces_at(system, x, zeta).centre > 0; });
}

FourSpringRest rest_under(const FourSprings& system, double load, double zeta) {
  constexpr double stride = 0.01;
  const auto excess = [&](double at) {
    return forces_at(system, centre_at_rest(system, at), at).top - load;
  };
  const double direction = excess(zeta) < 0 ? -1 : 1;
  const auto goes_on = [&](double at) { return direction * excess(at) > 0; };
  double from = zeta, to = zeta;
  while (goes_on(to)) {
    from = to;
    to += direction * stride;
    if (std::abs(to - zeta) > 10)
      throw std::runtime_error(
          fmt::format("four springs find no rest under a load of {:.4g} N", load));
  }
  const double rest = last_place(from, to, 1e-13, goes_on);
  return {.load = load, .zeta = rest, .x = centre_at_rest(system, rest)};
}

std::vector<FourSpringRest> hysteresis_loop(const FourSprings& system, double load_step,
                                            int steps) {
  std::vector<FourSpringRest> loop{{.load = 0, .zeta = 1, .x = 0}};
  const auto go = [&](int from, int to) {
    const int by = from < to ? 1 : -1;
    for (int i = from; i != to; i += by)
      loop.push_back(rest_under(system, (i + by) * load_step, loop.back().zeta));
  };
  go(0, steps);
  go(steps, -steps);
  go(-steps, steps);
  return loop;
}

}  // namespace springcheck::mss
