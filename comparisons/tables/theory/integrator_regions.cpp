#include "comparisons/tables/theory/integrator_regions.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace springcheck {
namespace {

using dynamics::Integrator;

constexpr double round_off = 1e-12;

Eigen::Matrix2d step_matrix(Integrator integrator, double dt, double damping_ratio) {
  Eigen::Matrix2d states = Eigen::Matrix2d::Identity();
  for (auto state : states.colwise()) {
    const double acceleration = -2 * damping_ratio * state[1] - state[0];
    dynamics::step(integrator, state[0], state[1], acceleration, dt, dt);
  }
  return states;
}

}  // namespace

double spectral_radius(Integrator integrator, double phase, double damping_ratio) {
  if (integrator != Integrator::implicit_euler)
    return step_matrix(integrator, phase, damping_ratio)
        .eigenvalues()
        .cwiseAbs()
        .maxCoeff();
  return 1 / step_matrix(Integrator::explicit_euler, -phase, damping_ratio)
                 .eigenvalues()
                 .cwiseAbs()
                 .minCoeff();
}

double region_border(Integrator integrator, double damping_ratio) {
  constexpr double stride = 0.01, farthest = 10;
  const bool is_implicit = integrator == Integrator::implicit_euler;
  const auto is_inside = [&](double r) {
    const double radius = spectral_radius(integrator, r, damping_ratio);
    return is_implicit ? radius > 1 + round_off : radius <= 1 + round_off;
  };
  double inside = 0, outside = stride;
  while (is_inside(outside)) {
    if (outside > farthest) return farthest;
    inside = outside;
    outside += stride;
  }
  while (outside - inside > round_off) {
    const double middle = (inside + outside) / 2;
    (is_inside(middle) ? inside : outside) = middle;
  }
  return inside;
}

double border_on_paper(Integrator integrator, double zeta) {
  if (integrator == Integrator::implicit_euler) return std::max(0., -2 * zeta);
  if (zeta < 0) return 0;
  if (integrator != Integrator::explicit_euler)
    return 2 * (std::sqrt(1 + zeta * zeta) - zeta);
  return zeta <= 1 ? 2 * zeta : 2 * (zeta - std::sqrt(zeta * zeta - 1));
}

}  // namespace springcheck
