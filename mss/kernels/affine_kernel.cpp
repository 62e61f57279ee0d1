#include "mss/kernels/affine_kernel.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <memory>
#include <tuple>

#include "mss/forces/forces.hpp"
#include "mss/kernels/affine_forces_paths.hpp"
#include "mss/kernels/lattice_cells.hpp"
#include "mss/networks/axes.hpp"

namespace springcheck::mss {
namespace {

using dynamics::Block;

/// The place in affine_springs of the spring between two corners.
std::size_t place_of(std::size_t first, std::size_t second) {
  const auto found = std::ranges::find_if(affine_springs, [&](const auto& ends) {
    return (ends[0] == first && ends[1] == second) ||
           (ends[0] == second && ends[1] == first);
  });
  assert(found != affine_springs.end());
  return static_cast<std::size_t>(found - affine_springs.begin());
}

/// k of a cell's springs, in squared lengths k/(2 L^2), in the order of affine_springs.
std::array<double, 24> stiffnesses(const Network& network, std::uint32_t cell,
                                   const std::array<std::size_t, 8>& corner) {
  std::array<double, 24> k{};
  for (const CellSpring& spring : network.cells.springs(cell))
    k[place_of(corner[spring.ends[0]], corner[spring.ends[1]])] =
        is_squared(network) ? spring.stiffness / (2 * spring.rest.squaredNorm())
                            : spring.stiffness;
  return k;
}

/// The constants of alike cells, see AffineBlock.
std::vector<double> alike_constants(const Eigen::Matrix3d& edges,
                                    const std::array<double, 24>& k) {
  std::vector<double> constants{edges.determinant()};
  const Eigen::Matrix3d gradients = edges.inverse();
  for (Eigen::Index i = 0; i < 3; ++i) {
    constants.insert(constants.end(), edges.col(i).begin(), edges.col(i).end());
    constants.insert(constants.end(), gradients.row(i).begin(), gradients.row(i).end());
  }
  for (std::size_t s = 0; s < 12; s += 4) constants.push_back(k[s]);
  for (std::size_t s = 12; s < 24; s += 2) constants.push_back(k[s]);
  return constants;
}

std::vector<double> own_constants(const Network& network, std::uint32_t cell,
                                  const std::array<std::size_t, 8>& corner) {
  std::array<Vector3, 8> gradients, places;
  for (std::size_t n = 0; n < 8; ++n) {
    gradients[corner[n]] = network.cells.gradients(cell)[n];
    places[corner[n]] = network.rest_positions[network.cells.nodes(cell)[n]];
  }
  std::vector<double> constants{network.cells.volume(cell)};
  for (std::size_t a = 1; a < 8; ++a)
    constants.insert(constants.end(), gradients[a].begin(), gradients[a].end());
  for (std::size_t a = 1; a < 8; ++a) {
    const Vector3 place = places[a] - places[0];
    constants.insert(constants.end(), place.begin(), place.end());
  }
  const auto k = stiffnesses(network, cell, corner);
  constants.insert(constants.end(), k.begin(), k.end());
  return constants;
}

template <class Real>
void add_constants(AffineBlock<Real>& affine, const Network& network, const Block& block,
                   const std::optional<Eigen::Matrix3d>& edges, std::size_t lanes) {
  const std::size_t count = affine.cells.count;
  if (edges) affine.is_cell.resize(count);
  for_each_cell(
      network, block, [&](std::size_t cell, std::uint32_t c, const auto& corner) {
        const std::size_t number = dynamics::number_of(block, cell, lanes);
        if (edges) {
          affine.is_cell[number] = 1;
          if (!affine.constants.empty()) return;
          for (const double x : alike_constants(*edges, stiffnesses(network, c, corner)))
            affine.constants.push_back(static_cast<Real>(x));
          return;
        }
        const std::vector<double> own = own_constants(network, c, corner);
        affine.constants.resize(own.size() * count);
        for (std::size_t n = 0; n < own.size(); ++n)
          affine.constants[n * count + number] = static_cast<Real>(own[n]);
      });
}

/// The nodal pressure is kappa/V_n sum V_e/8 (det F_e - 1), a cell's the mean over its
/// nodes.
template <class Real>
void add_pressures(AffineBlock<Real>& affine, const Network& network, const Block& block,
                   std::size_t lanes) {
  affine.pressure_per_sum.resize(block.nodes.size());
  for (std::size_t slot = 0; slot < block.nodes.size(); ++slot)
    if (block.nodes[slot] != dynamics::no_node)
      affine.pressure_per_sum[dynamics::element_of(block, slot, lanes)] =
          static_cast<Real>(network.volume_moduli.kappa / 64 /
                            network.volume_patches.volumes[block.nodes[slot]]);
}

/// Gives every damped edge to the first cell that has it.
class Dashpots {
 public:
  Dashpots(const Network& network, double damping_ratio)
      : network_(network),
        damping_ratio_(damping_ratio),
        is_taken_(network.damped_edges.size(), false) {}

  template <class Real>
  void add_to(AffineBlock<Real>& affine, const Block& block, std::size_t lanes) {
    const std::size_t count = affine.cells.count;
    affine.dashpots.resize(12 * count);
    dynamics::for_each_cell(block, [&](std::size_t cell, const auto& slots) {
      for (std::size_t s = 0; s < 12; ++s)
        affine.dashpots[s * count + dynamics::number_of(block, cell, lanes)] =
            static_cast<Real>(take(block.nodes[slots[affine_springs[s][0]]],
                                   block.nodes[slots[affine_springs[s][1]]]));
    });
  }

 private:
  /// c of the edge between two nodes, 0 if another cell has it.
  double take(NodeIndex first, NodeIndex second) {
    const auto ends = std::minmax(first, second);
    const auto edge = std::ranges::lower_bound(
        network_.damped_edges, std::pair<NodeIndex, NodeIndex>(ends), {},
        [](const Spring& spring) { return std::pair(spring.a, spring.b); });
    assert(edge != network_.damped_edges.end());
    assert(edge->a == ends.first && edge->b == ends.second);
    const auto number = static_cast<std::size_t>(edge - network_.damped_edges.begin());
    if (is_taken_[number]) return 0;
    is_taken_[number] = true;
    return dashpot_constant(network_, *edge, damping_ratio_);
  }

  const Network& network_;
  double damping_ratio_;
  std::vector<bool> is_taken_;
};

template <class Real>
struct AffineKernel {
  AffineBlock<Real> block;
  AffineFunctions<Real> functions;
};

bool has_patches(const Network& network) {
  return network.volume_moduli.kappa != 0 && network.volume_patches.size() > 0;
}

/// The weights of the icosahedron's axes and of the dodecahedron's, see AffineBlock.
std::array<double, 2> axis_weights(const Network& network) {
  if (is_squared(network)) return {1, 0};
  const std::span<const Axis> axes = all_of(network.axes);
  return {axes.front().weight, network.axes == Axes::six ? 0 : axes.back().weight};
}

}  // namespace

bool takes_affine_kernel(const Network& network) {
  const bool has_law =
      is_squared(network) || (network.strain_measure == StrainMeasure::engineering &&
                              network.axes != Axes::twenty_five);
  if (network.spring_modulus == 0 || !has_law) return false;
  for (std::size_t c = 0; c < network.cells.size(); ++c)
    if (network.cells.nodes(c).size() != 8) return false;
  return true;
}

template <class Real>
dynamics::BlockForces<Real> affine_kernel(const Network& network,
                                          const std::vector<Block>& blocks,
                                          double damping_ratio,
                                          dynamics::InstructionSet set) {
  const std::size_t lanes = dynamics::lane_count<Real>(set);
  const double rounding = dynamics::rounding_of(network.rest_positions);
  const bool patches = has_patches(network);
  Dashpots dashpots(network, damping_ratio);
  const std::array weights = axis_weights(network);
  const auto kernels = std::make_shared<std::vector<AffineKernel<Real>>>();
  for (const Block& block : blocks) {
    AffineBlock<Real> affine{
        .cells = dynamics::cells_in_arrays(block, lanes),
        .axis_modulus = static_cast<Real>(network.spring_modulus * weights.front()),
        .dual_axis_modulus = static_cast<Real>(network.spring_modulus * weights.back()),
        .volume_modulus = static_cast<Real>(network.volume_moduli.kappa)};
    const auto edges = dynamics::common_edges(block, network.rest_positions, rounding);
    add_constants(affine, network, block, edges, lanes);
    if (patches) add_pressures(affine, network, block, lanes);
    if (damping_ratio > 0) dashpots.add_to(affine, block, lanes);
    const AffineKind kind{.in_grid = block.is_grid(),
                          .alike = edges.has_value(),
                          .patches = patches,
                          .squared = is_squared(network),
                          .dashpots = damping_ratio > 0};
    kernels->push_back(
        {std::move(affine), SPRINGCHECK_ON_PATH(set, affine_functions(kind, Real{}))});
  }
  const auto on_block = [&](BlockFunction<Real> AffineFunctions<Real>::*function) {
    return [kernels, function](std::size_t b, const dynamics::BlockArrays<Real>& arrays) {
      const AffineKernel<Real>& kernel = (*kernels)[b];
      (kernel.functions.*function)(kernel.block, arrays);
    };
  };
  dynamics::BlockForces<Real> forces{.lanes = lanes,
                                     .add = on_block(&AffineFunctions<Real>::forces)};
  if (patches) forces.add_nodal_sums = on_block(&AffineFunctions<Real>::volume_sums);
  return forces;
}

template dynamics::BlockForces<double> affine_kernel(const Network& network,
                                                     const std::vector<Block>& blocks,
                                                     double damping_ratio,
                                                     dynamics::InstructionSet set);
template dynamics::BlockForces<float> affine_kernel(const Network& network,
                                                    const std::vector<Block>& blocks,
                                                    double damping_ratio,
                                                    dynamics::InstructionSet set);

}  // namespace springcheck::mss
