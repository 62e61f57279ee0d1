#include "mss/lattice_cells.hpp"

#include <cassert>
#include <cmath>
#include <limits>

namespace springcheck::mss {
namespace {

using dynamics::Block;

std::array<int, 3> place_of_corner(std::size_t corner) {
  return {static_cast<int>(corner & 1U), static_cast<int>(corner >> 1U & 1U),
          static_cast<int>(corner >> 2U)};
}

std::array<Vector3, 3> mean_edges(const Network& network, const Block& block,
                                  std::size_t cell) {
  const auto slots = block.corner_slots(cell);
  std::array<Vector3, 3> edges{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
  for (std::size_t c = 0; c < 8; ++c)
    for (std::size_t axis = 0; axis < 3; ++axis)
      edges[axis] += ((c >> axis & 1U) != 0 ? .25 : -.25) *
                     network.rest_positions[block.nodes[slots[c]]];
  return edges;
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

double rounding_of(const Network& network) {
  double reach = 0;
  for (const Vector3& x : network.rest_positions)
    reach = std::max(reach, x.cwiseAbs().maxCoeff());
  return 8 * std::numeric_limits<double>::epsilon() * reach;
}

CommonShape common_shape(const Network& network, const Block& block, double rounding) {
  CommonShape common;
  for_each_cell(
      network, block, [&](std::size_t cell, std::uint32_t c, const auto& corner) {
        const auto edges = mean_edges(network, block, cell);
        const double volume = network.cells.volume(c);
        if (common.volume == 0) {
          common.edges = edges;
          common.volume = volume;
          common.relative_rounding = 4 * rounding / std::cbrt(volume);
          for (std::size_t i = 0; i < 13; ++i) {
            common.rest[i] = Vector3::Zero();
            for (std::size_t j = 0; j < 3; ++j)
              common.rest[i] += lattice_steps[i][j] * edges[j];
          }
        }
        bool alike =
            equal_but_for_rounding(volume, common.volume, common.relative_rounding);
        for (std::size_t i = 0; i < 3; ++i)
          alike = alike && equal_vectors(edges[i], common.edges[i], rounding);
        for (const CellSpring& spring : network.cells.springs(c)) {
          const PlacedSpring place =
              placed(block, cell, corner[spring.ends[0]], corner[spring.ends[1]], spring);
          double& share = common.share[place.step];
          if (share == 0) share = place.stiffness;
          alike =
              alike &&
              equal_but_for_rounding(place.stiffness, share, common.relative_rounding) &&
              equal_vectors(place.rest, common.rest[place.step], rounding);
        }
        common.alike = common.alike && alike;
      });
  return common;
}

}  // namespace springcheck::mss
