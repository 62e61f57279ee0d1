#include "mss/lattice_kernel.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <unordered_map>

#include "mss/lattice_forces_paths.hpp"

namespace springcheck::mss {
namespace {

using dynamics::Block;

/// A cell's spring where the grid has it: leaves `slot` by lattice_steps[step].
struct PlacedSpring {
  std::size_t slot;
  std::size_t step;
  NodeIndex from, to;
  double stiffness;
  Vector3 rest;  // along the step
};

std::array<int, 3> place_of_corner(std::size_t corner) {
  return {static_cast<int>(corner & 1U), static_cast<int>(corner >> 1U & 1U),
          static_cast<int>(corner >> 2U)};
}

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

/// Calls visit(cell number, cell of the network, corner of each of its nodes).
template <class Visit>
void for_each_cell(const Network& network, const Block& block, const Visit& visit) {
  for (std::size_t cell = 0; cell < block.cells.size(); ++cell) {
    if (block.cells[cell] == dynamics::no_cell) continue;
    const auto slots = block.corner_slots(cell);
    const auto nodes = network.cells.nodes(block.cells[cell]);
    std::array<std::size_t, 8> corner{};
    for (std::size_t c = 0; c < 8; ++c)
      corner[static_cast<std::size_t>(std::ranges::find(nodes, block.nodes[slots[c]]) -
                                      nodes.begin())] = c;
    visit(cell, block.cells[cell], corner);
  }
}

/// Calls visit(placed spring) for every spring of every cell of the block.
template <class Visit>
void for_each_placed(const Network& network, const Block& block, const Visit& visit) {
  for_each_cell(network, block,
                [&](std::size_t cell, std::uint32_t c, const auto& corner) {
                  for (const CellSpring& spring : network.cells.springs(c))
                    visit(placed(block, cell, corner[spring.ends[0]],
                                 corner[spring.ends[1]], spring));
                });
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

/// What the cells of a block have in common, if they do: of each step the rest vector and
/// one share's stiffness, 0 where there are none; the mean edges and the volume.
struct Common {
  std::array<Vector3, 13> rest{};
  std::array<double, 13> share{};
  std::array<Vector3, 3> edges;
  double volume = 0;
  double relative_rounding = 0;
  bool alike = true;
};

/// Positions differ from those of a perfect grid by their rounding, `rounding` in units
/// of length; volumes and stiffnesses by a few times that over the cells' edge.
bool equal_vectors(const Vector3& a, const Vector3& b, double rounding) {
  return (a - b).cwiseAbs().maxCoeff() <= rounding;
}
bool equal_numbers(double a, double b, double relative_rounding) {
  return std::abs(a - b) <= relative_rounding * std::abs(b);
}

double rounding_of(const Network& network) {
  double reach = 0;
  for (const Vector3& x : network.rest_positions)
    reach = std::max(reach, x.cwiseAbs().maxCoeff());
  return 8 * std::numeric_limits<double>::epsilon() * reach;
}

Common common_of(const Network& network, const Block& block, double rounding) {
  Common common;
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
        bool alike = equal_numbers(volume, common.volume, common.relative_rounding);
        for (std::size_t i = 0; i < 3; ++i)
          alike = alike && equal_vectors(edges[i], common.edges[i], rounding);
        for (const CellSpring& spring : network.cells.springs(c)) {
          const PlacedSpring place =
              placed(block, cell, corner[spring.ends[0]], corner[spring.ends[1]], spring);
          double& share = common.share[place.step];
          if (share == 0) share = place.stiffness;
          alike = alike &&
                  equal_numbers(place.stiffness, share, common.relative_rounding) &&
                  equal_vectors(place.rest, common.rest[place.step], rounding);
        }
        common.alike = common.alike && alike;
      });
  return common;
}

/// The springs between nodes that blocks share, each with all its shares, in the first
/// block that has it.
class BorderSprings {
 public:
  struct Sum {
    std::size_t block, slot, step;
    double stiffness, length;
    std::uint8_t shares;
  };

  BorderSprings(const Network& network, const std::vector<Block>& blocks,
                std::vector<Common>& common)
      : is_shared_(network.rest_positions.size(), false) {
    std::vector<bool> is_known(is_shared_.size(), false);
    for (const Block& block : blocks)
      for (const NodeIndex node : block.nodes) {
        if (node == dynamics::no_node) continue;
        if (is_known[node]) is_shared_[node] = true;
        is_known[node] = true;
      }
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for_each_placed(network, blocks[b], [&](const PlacedSpring& spring) {
        if (!has(spring)) return;
        const auto [first, second] = std::minmax(spring.from, spring.to);
        const auto [entry, is_new] = sums_.try_emplace(
            std::uint64_t{first} << 32U | second, Sum{.block = b,
                                                      .slot = spring.slot,
                                                      .step = spring.step,
                                                      .stiffness = 0,
                                                      .length = spring.rest.norm(),
                                                      .shares = 0});
        Sum& sum = entry->second;
        sum.stiffness += spring.stiffness;
        ++sum.shares;
        Common& owner = common[sum.block];
        if (!equal_numbers(spring.stiffness, owner.share[sum.step],
                           owner.relative_rounding))
          owner.alike = false;
      });
  }

  [[nodiscard]] bool has(const PlacedSpring& spring) const {
    return is_shared_[spring.from] && is_shared_[spring.to];
  }
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const auto& [nodes, sum] : sums_) visit(sum);
  }

 private:
  std::vector<bool> is_shared_;
  std::unordered_map<std::uint64_t, Sum> sums_;
};

template <class Real>
LatticeBlock<Real> with_common(const Block& block, const Common& common,
                               const Network& network, std::size_t lanes) {
  LatticeBlock<Real> lattice{.row = block.row,
                             .layer = block.layer,
                             .rows = block.nodes.size() / lanes,
                             .lanes = lanes};
  const auto rounded = [](const Vector3& v) {
    return std::array{static_cast<Real>(v[0]), static_cast<Real>(v[1]),
                      static_cast<Real>(v[2])};
  };
  const double kappa = network.volume_modulus;
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
      lattice.fourfold_edges[i] = rounded(4 * common.edges[i]);
    lattice.sixteenfold_area = rounded(16 * common.edges[0].cross(common.edges[1]));
    lattice.push_per_change = static_cast<Real>(-kappa / common.volume / (4. * 16 * 64));
    lattice.is_cell.resize(slots);
    for (std::size_t s = 0; s < slots; ++s)
      lattice.is_cell[lattice.element(s)] = block.cells[s] == dynamics::no_cell ? 0 : 1;
    return lattice;
  }
  // Ghosts as in dynamics::BlockArrays, but of what never moves.
  const std::size_t rows = lattice.rows + block.layer + block.row + 2;
  for (std::size_t i = 0; i < 3; ++i) {
    lattice.position[i].resize(rows * lanes);
    for (std::size_t at = 0; at < rows * lanes; ++at) {
      const std::size_t slot = at / lanes + at % lanes * lattice.rows;
      if (slot < slots && block.nodes[slot] != dynamics::no_node)
        lattice.position[i][at] = static_cast<Real>(
            network.rest_positions[block.nodes[slot]][static_cast<Eigen::Index>(i)]);
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
                std::size_t slot, std::uint8_t shares, double stiffness, double length) {
  if (alike) {
    std::uint8_t& count = lattice.shares[step][lattice.element(slot)];
    count = static_cast<std::uint8_t>(count + shares);
    return;
  }
  lattice.stiffnesses[step][lattice.element(slot)] += static_cast<Real>(stiffness);
  lattice.tensions[step][lattice.element(slot)] += static_cast<Real>(stiffness * length);
}

template <class Real>
LatticeForces<Real> compiled(const LatticeKind& kind, dynamics::InstructionSet set) {
#if defined(__x86_64__)
  if (set == dynamics::InstructionSet::avx512)
    return avx512::lattice_forces(kind, Real{});
  if (set == dynamics::InstructionSet::avx2) return avx2::lattice_forces(kind, Real{});
#endif
  return portable::lattice_forces(kind, Real{});
}

template <class Real>
struct Kernel {
  LatticeBlock<Real> block;
  LatticeForces<Real> forces;
};

}  // namespace

bool takes_lattice_kernel(const Network& network) {
  return network.cell_springs == RestLength::constant && network.spring_modulus == 0 &&
         network.volume_stars.size() == 0;
}

template <class Real>
dynamics::BlockForces<Real> lattice_kernel(const Network& network,
                                           const std::vector<Block>& blocks,
                                           double damping_ratio,
                                           dynamics::InstructionSet set) {
  const double rounding = rounding_of(network);
  std::vector<Common> common;
  for (const Block& block : blocks) common.push_back(common_of(network, block, rounding));
  const BorderSprings border(network, blocks, common);
  const std::size_t lanes = dynamics::lane_count<Real>(set);
  const auto kernels = std::make_shared<std::vector<Kernel<Real>>>();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    LatticeBlock<Real> lattice = with_common<Real>(blocks[b], common[b], network, lanes);
    lattice.twice_damping_ratio = static_cast<Real>(2 * damping_ratio);
    bool has_face_diagonals = false;
    for_each_placed(network, blocks[b], [&](const PlacedSpring& spring) {
      if (kind_of(lattice_steps[spring.step]) == SpringKind::face_diagonal)
        has_face_diagonals = true;
      if (!border.has(spring))
        add_spring(lattice, common[b].alike, spring.step, spring.slot, 1,
                   spring.stiffness, spring.rest.norm());
    });
    const LatticeKind kind{.alike = common[b].alike,
                           .face_diagonals = has_face_diagonals,
                           .correction = network.volume_modulus != 0,
                           .dashpots = damping_ratio > 0};
    kernels->push_back({std::move(lattice), compiled<Real>(kind, set)});
  }
  border.for_each([&](const BorderSprings::Sum& sum) {
    add_spring((*kernels)[sum.block].block, common[sum.block].alike, sum.step, sum.slot,
               sum.shares, sum.stiffness, sum.length);
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
