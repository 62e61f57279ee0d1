#include "dynamics/marching/small_motions.hpp"

#include <cmath>
#include <random>
#include <utility>

namespace springcheck::dynamics {

SmallMotions about_rest(std::span<const double> masses, std::vector<bool> is_free,
                        double cell_edge, bool has_dashpots) {
  const std::vector<Vector3> at_rest(masses.size(), Vector3::Zero());
  return {.state = {.displacements = at_rest, .velocities = at_rest},
          .masses = masses,
          .is_free = std::move(is_free),
          .amplitude = probe * cell_edge,
          .has_dashpots = has_dashpots};
}

Combination::Combination(const SmallMotions& system, double stiffness_factor,
                         double dashpot_factor)
    : system_(system), stiffness_(stiffness_factor), dashpots_(dashpot_factor) {
  for (std::size_t i = 0; i < system.is_free.size(); ++i)
    if (system.is_free[i]) components_.push_back(i);
  inverse_root_mass_.resize(static_cast<Eigen::Index>(components_.size()));
  for (std::size_t n = 0; n < components_.size(); ++n)
    inverse_root_mass_[static_cast<Eigen::Index>(n)] =
        1 / std::sqrt(system.masses[components_[n] / 3]);
}

Field Combination::start() const {
  std::mt19937_64 random(1);
  Field v(size());
  for (double& component : v)
    component = static_cast<double>(random() >> 11U) * 0x1p-52 - 1;
  return v / v.norm();
}

Field Combination::apply(const Field& v) const {
  const Field u = v.cwiseProduct(inverse_root_mass_);
  const double scale = system_.amplitude / u.cwiseAbs().maxCoeff();
  const double moved = stiffness_ == 0 ? 0 : scale;
  const double pushed = stiffness_ == 0 ? scale : scale * dashpots_ / stiffness_;
  const auto ahead = system_.forces(at(u, moved, pushed)),
             behind = system_.forces(at(u, -moved, -pushed));
  const double factor = (stiffness_ == 0 ? dashpots_ : stiffness_) / (2 * scale);
  Field result(v.size());
  for (std::size_t n = 0; n < components_.size(); ++n) {
    const std::size_t node = components_[n] / 3;
    const auto i = static_cast<Eigen::Index>(components_[n] % 3);
    result[static_cast<Eigen::Index>(n)] = factor * (behind[node][i] - ahead[node][i]);
  }
  return result.cwiseProduct(inverse_root_mass_);
}

State Combination::at(const Field& u, double moved, double pushed) const {
  State state = system_.state;
  for (std::size_t n = 0; n < components_.size(); ++n) {
    const std::size_t node = components_[n] / 3;
    const auto i = static_cast<Eigen::Index>(components_[n] % 3);
    state.displacements[node][i] += moved * u[static_cast<Eigen::Index>(n)];
    state.velocities[node][i] += pushed * u[static_cast<Eigen::Index>(n)];
  }
  return state;
}

}  // namespace springcheck::dynamics
