#include "mss/kernels/lattice_cells.hpp"

#include <Eigen/LU>
#include <cassert>
#include <cmath>

#include "dynamics/blocks/block_cells.hpp"

namespace springcheck::mss {
namespace {

using dynamics::Block;

std::array<int, 3> place_of_corner(std::size_t corner) {
  return {static_cast<int>(corner & 1U), static_cast<int>(corner >> 1U & 1U),
          static_cast<int>(corner >> 2U)};
}

bool equal_vectors(const Vector3& a, const Vector3& b, double rounding) {
  return (a - b).cwiseAbs().maxCoeff() <= rounding;
}

}  // namespace

PlacedSpring placed(const Block& block, std::size_t cell, std::size_t first,
                    std::size_t second, const CellSpring& spring) {
  Vector3 rest = spring.rest;
  for (int turn = 0; turn < 2; ++turn) {
    const auto a = place_of_corner(first), b = place_of_corner(second);
    const auto step = std::ranges::find(
        lattice_steps, std::array{b[0] - a[0], b[1] - a[1], b[2] - a[2]});
    if (step != lattice_steps.end()) {
      const auto slots = block.corner_slots(cell);
      return {.slot = slots[first],
              .step = static_cast<std::size_t>(step - lattice_steps.begin()),
              .from = block.nodes[slots[first]],
              .to = block.nodes[slots[second]],
              .stiffness = spring.stiffness,
              .rest = rest};
    }
    std::swap(first, second);
    rest = -rest;
  }
  assert(false);
  return {};
}

bool equal_but_for_rounding(double a, double b, double relative_rounding) {
  return std::abs(a - b) <= relative_rounding * std::abs(b);
}

CommonShape common_shape(const Network& network, const Block& block, double rounding) {
  const auto edges = dynamics::common_edges(block, network.rest_positions, rounding);
  if (!edges) return {};
  CommonShape common{.edges = *edges, .volume = edges->determinant(), .alike = true};
  common.relative_rounding = 4 * rounding / std::cbrt(common.volume);
  for (std::size_t i = 0; i < 13; ++i) {
    const auto& [x, y, z] = lattice_steps[i];
    common.rest[i] = *edges * Vector3(x, y, z);
  }
  for_each_placed(network, block, [&](const PlacedSpring& spring) {
    double& share = common.share[spring.step];
    if (share == 0) share = spring.stiffness;
    common.alike =
        common.alike &&
        equal_but_for_rounding(spring.stiffness, share, common.relative_rounding) &&
        equal_vectors(spring.rest, common.rest[spring.step], 2 * rounding);
  });
  return common;
}

}  // namespace springcheck::mss
