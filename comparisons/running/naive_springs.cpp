#include "comparisons/running/naive_springs.hpp"

#include <algorithm>
#include <cmath>

namespace springcheck {
namespace {

using Triple = std::array<double, 3>;

Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

NaiveSprings::NaiveSprings(const mss::Network& network,
                           const std::vector<Vector3>& displacements)
    : springs_(network.springs),
      masses_(network.masses),
      volume_modulus_(network.volume_moduli.kappa),
      positions_(displacements.size()),
      velocities_(displacements.size()),
      forces_(displacements.size()) {
  for (std::size_t c = 0; c < network.cells.size(); ++c) {
    Cell& cell = cells_.emplace_back();
    std::ranges::copy(network.cells.nodes(c), cell.nodes.begin());
    cell.volume = network.cells.volume(c);
  }
  for (std::size_t n = 0; n < positions_.size(); ++n)
    for (std::size_t i = 0; i < 3; ++i)
      positions_[n][i] =
          (network.rest_positions[n] + displacements[n])[static_cast<Eigen::Index>(i)];
}

void NaiveSprings::update_forces() {
  std::ranges::fill(forces_, Triple{});
  for (const auto& [a, b, stiffness, rest_length] : springs_) {
    Triple d;
    for (std::size_t i = 0; i < 3; ++i) d[i] = positions_[b][i] - positions_[a][i];
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const double factor = stiffness * (length - rest_length) / length;
    for (std::size_t i = 0; i < 3; ++i) {
      forces_[a][i] += factor * d[i];
      forces_[b][i] -= factor * d[i];
    }
  }
  if (volume_modulus_ == 0) return;
  for (const auto& [nodes, volume] : cells_) {
    // The four edges along each direction, from low to high, and the signs of dV/dx.
    constexpr std::size_t edges[3][4][2] = {{{0, 1}, {3, 2}, {4, 5}, {7, 6}},
                                            {{0, 3}, {1, 2}, {4, 7}, {5, 6}},
                                            {{0, 4}, {1, 5}, {3, 7}, {2, 6}}};
    Triple mean[3] = {};
    for (std::size_t e = 0; e < 3; ++e)
      for (const auto& [low, high] : edges[e])
        for (std::size_t i = 0; i < 3; ++i)
          mean[e][i] += .25 * (positions_[nodes[high]][i] - positions_[nodes[low]][i]);
    const Triple area[3] = {cross(mean[1], mean[2]), cross(mean[2], mean[0]),
                            cross(mean[0], mean[1])};
    const double now =
        mean[0][0] * area[0][0] + mean[0][1] * area[0][1] + mean[0][2] * area[0][2];
    const double push = .25 * volume_modulus_ * (now - volume) / volume;
    for (std::size_t e = 0; e < 3; ++e)
      for (const auto& [low, high] : edges[e])
        for (std::size_t i = 0; i < 3; ++i) {
          forces_[nodes[low]][i] += push * area[e][i];
          forces_[nodes[high]][i] -= push * area[e][i];
        }
  }
}

void NaiveSprings::advance(double dt) {
  update_forces();
  for (std::size_t n = 0; n < positions_.size(); ++n)
    for (std::size_t i = 0; i < 3; ++i) {
      velocities_[n][i] += dt * forces_[n][i] / masses_[n];
      positions_[n][i] += dt * velocities_[n][i];
    }
}

}  // namespace springcheck
