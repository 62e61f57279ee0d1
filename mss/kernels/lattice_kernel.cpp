#include "mss/kernels/lattice_kernel.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include "mss/kernels/border_springs.hpp"
#include "mss/kernels/lattice_forces_paths.hpp"

namespace springcheck::mss {
namespace {

using dynamics::Block;

/// What a spring's tension over its length is made of: k - k L/l, in squared lengths
/// k/(2 L^2) l^2 - k/2.
struct SpringNumbers {
  double stiffness, tension;
};

SpringNumbers numbers_of(const Network& network, double k, double L) {
  if (is_squared(network)) return {.stiffness = k / (2 * L * L), .tension = k / 2};
  return {.stiffness = k, .tension = k * L};
}

/// The component that each edge has alone, if all have but one.
std::optional<std::array<std::size_t, 3>> along_axes(const CommonShape& shape) {
  std::array<std::size_t, 3> along{};
  for (std::size_t s = 0; s < 3; ++s) {
    Vector3 edge = shape.edges.col(static_cast<Eigen::Index>(s)).cwiseAbs();
    Eigen::Index component = 0;
    const double length = edge.maxCoeff(&component);
    edge[component] = 0;
    if (edge.maxCoeff() > shape.relative_rounding * length) return std::nullopt;
    along[s] = static_cast<std::size_t>(component);
  }
  return along;
}

/// What the kernel of alike boxes in squared lengths needs.
template <class Real>
void add_squares(LatticeBlock<Real>& lattice, const CommonShape& common, double kappa) {
  lattice.along = along_axes(common).value();
  for (std::size_t s = 0; s < 3; ++s) {
    const double edge = common.edges(static_cast<Eigen::Index>(lattice.along[s]),
                                     static_cast<Eigen::Index>(s));
    lattice.box[s] = static_cast<Real>(edge);
    lattice.trace_per_square[s] = static_cast<Real>(1 / (32 * edge * edge));
    lattice.push_per_trace[s] =
        static_cast<Real>(-kappa * common.volume / (16 * edge * edge));
  }
  for (std::size_t i = 0; i < 13; ++i) {
    const double square = common.rest[i].squaredNorm();
    lattice.rest_square[i] = static_cast<Real>(square);
    for (std::size_t shares = 0; shares < dynamics::largest_look_up; ++shares)
      lattice.stiffness_of[i][shares] =
          static_cast<Real>(static_cast<double>(shares) * common.share[i] / (2 * square));
  }
}

template <class Real>
LatticeBlock<Real> with_common(const Block& block, const CommonShape& common,
                               const Network& network, std::size_t lanes) {
  LatticeBlock<Real> lattice{.row = block.row,
                             .layer = block.layer,
                             .rows = block.nodes.size() / lanes,
                             .lanes = lanes};
  const auto rounded = [](const Vector3& v) {
    return std::array{static_cast<Real>(v[0]), static_cast<Real>(v[1]),
                      static_cast<Real>(v[2])};
  };
  const double kappa = network.volume_moduli.kappa;
  lattice.volume_modulus = static_cast<Real>(kappa);
  const std::size_t slots = block.nodes.size();
  if (common.alike) {
    for (std::size_t i = 0; i < 13; ++i) {
      lattice.rest[i] = rounded(common.rest[i]);
      lattice.stiffness[i] = static_cast<Real>(common.share[i]);
      lattice.tension[i] = static_cast<Real>(common.share[i] * common.rest[i].norm());
      lattice.shares[i].resize(slots);
    }
    for (std::size_t i = 0; i < 3; ++i)
      lattice.fourfold_edges[i] =
          rounded(4 * common.edges.col(static_cast<Eigen::Index>(i)));
    if (is_squared(network)) add_squares(lattice, common, kappa);
    lattice.sixteenfold_area =
        rounded(16 * common.edges.col(0).cross(common.edges.col(1)));
    lattice.push_per_change = static_cast<Real>(-kappa / common.volume / (4. * 16 * 64));
    lattice.is_cell.resize(slots);
    for (std::size_t s = 0; s < slots; ++s)
      lattice.is_cell[lattice.element(s)] = block.cells[s] == dynamics::no_cell ? 0 : 1;
    return lattice;
  }
  // Places of nodes are taken from one of the block's own: rounded where they stand,
  // those far from the origin would lose what forces need.
  const NodeIndex first = *std::ranges::find_if(
      block.nodes, [](NodeIndex node) { return node != dynamics::no_node; });
  // Ghosts as in dynamics::BlockArrays, but of what never moves.
  const std::size_t rows = lattice.rows + block.layer + block.row + 2;
  for (std::size_t i = 0; i < 3; ++i) {
    lattice.position[i].resize(rows * lanes);
    for (std::size_t at = 0; at < rows * lanes; ++at) {
      const std::size_t slot = at / lanes + at % lanes * lattice.rows;
      if (slot < slots && block.nodes[slot] != dynamics::no_node)
        lattice.position[i][at] = static_cast<Real>(
            (network.rest_positions[block.nodes[slot]] -
             network.rest_positions[first])[static_cast<Eigen::Index>(i)]);
    }
  }
  for (auto& list : lattice.stiffnesses) list.resize(slots);
  for (auto& list : lattice.tensions) list.resize(slots);
  if (kappa == 0) return lattice;
  lattice.cell_volumes.resize(slots);
  for (auto& component : lattice.gradients)
    for (auto& list : component) list.resize(slots);
  for_each_cell(
      network, block, [&](std::size_t cell, std::uint32_t c, const auto& corner) {
        lattice.cell_volumes[lattice.element(cell)] =
            static_cast<Real>(network.cells.volume(c));
        for (std::size_t n = 0; n < 8; ++n)
          for (std::size_t i = 0; i < 3; ++i)
            lattice.gradients[i][corner[n]][lattice.element(cell)] = static_cast<Real>(
                network.cells.gradients(c)[n][static_cast<Eigen::Index>(i)]);
      });
  return lattice;
}

template <class Real>
void add_spring(LatticeBlock<Real>& lattice, bool alike, std::size_t step,
                std::size_t slot, std::uint8_t shares, const SpringNumbers& numbers) {
  if (alike) {
    std::uint8_t& count = lattice.shares[step][lattice.element(slot)];
    count = static_cast<std::uint8_t>(count + shares);
    return;
  }
  lattice.stiffnesses[step][lattice.element(slot)] +=
      static_cast<Real>(numbers.stiffness);
  lattice.tensions[step][lattice.element(slot)] += static_cast<Real>(numbers.tension);
}

template <class Real>
struct LatticeKernel {
  LatticeBlock<Real> block;
  LatticeForces<Real> forces;
};

}  // namespace

bool takes_lattice_kernel(const Network& network) {
  return (network.strain_measure == StrainMeasure::engineering || is_squared(network)) &&
         network.cell_springs == RestLength::constant && network.spring_modulus == 0 &&
         network.volume_patches.size() == 0;
}

template <class Real>
dynamics::BlockForces<Real> lattice_kernel(const Network& network,
                                           const std::vector<Block>& blocks,
                                           double damping_ratio,
                                           dynamics::InstructionSet set) {
  const double rounding = dynamics::rounding_of(network.rest_positions);
  std::vector<CommonShape> common;
  for (const Block& block : blocks) {
    common.push_back(common_shape(network, block, rounding));
    // Boxes turned otherwise go by the kernel of those that are not alike.
    if (is_squared(network) && !along_axes(common.back())) common.back().alike = false;
  }
  const BorderSprings border(network, blocks, common);
  const std::size_t lanes = dynamics::lane_count<Real>(set);
  const auto kernels = std::make_shared<std::vector<LatticeKernel<Real>>>();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    LatticeBlock<Real> lattice = with_common<Real>(blocks[b], common[b], network, lanes);
    lattice.twice_damping_ratio = static_cast<Real>(2 * damping_ratio);
    bool has_face_diagonals = false;
    for_each_placed(network, blocks[b], [&](const PlacedSpring& spring) {
      if (kind_of(lattice_steps[spring.step]) == SpringKind::face_diagonal)
        has_face_diagonals = true;
      if (!border.has(spring))
        add_spring(lattice, common[b].alike, spring.step, spring.slot, 1,
                   numbers_of(network, spring.stiffness, spring.rest.norm()));
    });
    const LatticeKind kind{.alike = common[b].alike,
                           .squared = is_squared(network),
                           .face_diagonals = has_face_diagonals,
                           .correction = network.volume_moduli.kappa != 0,
                           .dashpots = damping_ratio > 0};
    kernels->push_back(
        {std::move(lattice), SPRINGCHECK_ON_PATH(set, lattice_forces(kind, Real{}))});
  }
  border.for_each([&](const BorderSprings::Sum& sum) {
    add_spring((*kernels)[sum.block].block, common[sum.block].alike, sum.step, sum.slot,
               sum.shares, numbers_of(network, sum.stiffness, sum.length));
  });
  return {.lanes = lanes,
          .add = [kernels](std::size_t b, const dynamics::BlockArrays<Real>& arrays) {
            (*kernels)[b].forces((*kernels)[b].block, arrays);
          }};
}

template dynamics::BlockForces<double> lattice_kernel(const Network& network,
                                                      const std::vector<Block>& blocks,
                                                      double damping_ratio,
                                                      dynamics::InstructionSet set);
template dynamics::BlockForces<float> lattice_kernel(const Network& network,
                                                     const std::vector<Block>& blocks,
                                                     double damping_ratio,
                                                     dynamics::InstructionSet set);

}  // namespace springcheck::mss
