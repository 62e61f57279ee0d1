#include "mss/tissue/tissue_kernel.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mss/tissue/tissue_forces_paths.hpp"

namespace springcheck::mss {
namespace {

using dynamics::Block;
using Eigen::Index;

TissueConstants constants_of(const tissue::Solid& solid) {
  const tissue::MaxwellModel& model = solid.shear;
  const double p = model.hardening_index;
  const auto branch = [&](const tissue::BranchModuli& moduli) {
    return TissueConstants::Branch{moduli.linear, moduli.hardening / (p + 1)};
  };
  TissueConstants constants{
      .elastic = branch(model.elastic),
      .viscosity = model.viscosity,
      .bulk_ratio = solid.bulk_ratio,
      .inverse_square = 1 / (model.linear_limit * model.linear_limit),
      .exponent = p / 2};
  for (const tissue::MaxwellBranch& one : model.branches)
    constants.branches.push_back(branch(one.moduli));
  return constants;
}

/// The cell's nodes by the block's corners.
std::array<Index, 8> nodes_at_corners(const TissueBody& body, const Block& block,
                                      std::uint32_t cell,
                                      const std::array<std::uint32_t, 8>& slots) {
  const CellNodes& nodes = body.cells[cell];
  std::array<Index, 8> at{};
  for (std::size_t c = 0; c < 8; ++c)
    at[c] = std::ranges::find(nodes, block.nodes[slots[c]]) - nodes.begin();
  return at;
}

/// The constants of alike cells, see TissueBlock.
std::vector<double> alike_constants(const Eigen::Matrix3d& edges) {
  const double volume = edges.determinant();
  std::vector<double> constants{volume, hourglass_length(volume)};
  const Eigen::Matrix3d directions = edges.inverse();
  for (Index k = 0; k < 3; ++k)
    constants.insert(constants.end(), directions.row(k).begin(), directions.row(k).end());
  return constants;
}

std::vector<double> own_constants(const TissueShape& shape,
                                  const std::array<Index, 8>& nodes) {
  std::vector<double> constants{shape.volume, hourglass_length(shape.volume)};
  for (std::size_t a = 1; a < 8; ++a) {
    const Vector3 gradient = shape.gradients.col(nodes[a]);
    constants.insert(constants.end(), gradient.begin(), gradient.end());
  }
  // The last constants are the projection's eigenvectors to the eigenvalue 1.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> projection(shape.hourglasses);
  for (Index m = 4; m < 8; ++m)
    for (const Index node : nodes)
      constants.push_back(projection.eigenvectors()(node, m));
  return constants;
}

TissueBlock tissue_block(const TissueBody& body, const Block& block,
                         const std::optional<Eigen::Matrix3d>& edges, std::size_t lanes) {
  TissueBlock tissue{.cells = dynamics::cells_in_arrays(block, lanes)};
  const std::size_t count = tissue.cells.count;
  if (edges) {
    tissue.constants = alike_constants(*edges);
    tissue.is_cell.resize(count);
  } else {
    tissue.constants.resize(own_tissue_constants * count);
  }
  dynamics::for_each_cell(block, [&](std::size_t cell, const auto& slots) {
    const std::size_t number = dynamics::number_of(block, cell, lanes);
    if (edges) {
      tissue.is_cell[number] = 1;
      return;
    }
    const std::uint32_t c = block.cells[cell];
    const std::vector<double> own =
        own_constants(body.shape(c), nodes_at_corners(body, block, c, slots));
    for (std::size_t n = 0; n < own.size(); ++n)
      tissue.constants[place_in_packs(number, n, own.size(), lanes)] = own[n];
  });
  const std::size_t size = tissue_memory_size(body.solid.shear.branches.size());
  std::vector<double> rest(size);
  tissue::set_to_rest(rest);
  tissue.memories.resize(size * count);
  for (std::size_t cell = 0; cell < count; ++cell)
    for (std::size_t n = 0; n < size; ++n)
      tissue.memories[place_in_packs(cell, n, size, lanes)] = rest[n];
  return tissue;
}

struct TissueKernel {
  TissueBlock block;
  TissueFunction looks, advances;
};

}  // namespace

TissueForces tissue_kernel(const TissueBody& body, const std::vector<Block>& blocks,
                           dynamics::InstructionSet set) {
  const std::size_t lanes = dynamics::lane_count<double>(set);
  const double rounding = dynamics::rounding_of(body.rest_positions);
  const auto constants =
      std::make_shared<const TissueConstants>(constants_of(body.solid));
  const auto kernels = std::make_shared<std::vector<TissueKernel>>();
  for (const Block& block : blocks) {
    const auto edges = dynamics::common_edges(block, body.rest_positions, rounding);
    const auto function = [&](bool advances) {
      const TissueKind kind{
          .in_grid = block.is_grid(), .alike = edges.has_value(), .advances = advances};
      return SPRINGCHECK_ON_PATH(set, tissue_function(kind));
    };
    kernels->push_back({.block = tissue_block(body, block, edges, lanes),
                        .looks = function(false),
                        .advances = function(true)});
  }
  const auto step = std::make_shared<const tissue::MemoryStep*>(nullptr);
  const auto add = [=](std::size_t b, const dynamics::BlockArrays<double>& arrays) {
    TissueKernel& kernel = (*kernels)[b];
    (*step != nullptr ? kernel.advances : kernel.looks)(*constants, kernel.block, *step,
                                                        arrays);
  };
  const auto memories = [&body, kernels, lanes](const std::vector<Block>& of) {
    const std::size_t branches = body.solid.shear.branches.size(),
                      size = tissue_memory_size(branches),
                      state_size = tissue::state_size(branches);
    std::vector<double> all = memories_at_rest(body);
    for (std::size_t b = 0; b < of.size(); ++b)
      dynamics::for_each_cell(of[b], [&](std::size_t cell, const auto&) {
        const std::size_t number = dynamics::number_of(of[b], cell, lanes);
        for (std::size_t n = 0; n < size; ++n)
          all[(of[b].cells[cell] + 1) * state_size - size + n] =
              (*kernels)[b].block.memories[place_in_packs(number, n, size, lanes)];
      });
    return all;
  };
  return {.forces = {.lanes = lanes, .add = add}, .step = step, .memories = memories};
}

TissueForces plain_tissue_forces(const TissueBody& body) {
  struct Room {
    std::vector<Vector3> positions, velocities, forces;
    std::vector<double> memories;
    std::vector<tissue::PointStress> stresses;
  };
  const std::size_t nodes = body.rest_positions.size();
  const auto room = std::make_shared<Room>(
      Room{.positions = body.rest_positions,
           .velocities = std::vector<Vector3>(nodes, Vector3::Zero()),
           .forces = std::vector<Vector3>(nodes, Vector3::Zero()),
           .memories = memories_at_rest(body),
           .stresses = std::vector<tissue::PointStress>(body.cells.size())});
  const auto step = std::make_shared<const tissue::MemoryStep*>(nullptr);
  const auto add = [&body, room, step](std::size_t,
                                       const dynamics::BlockArrays<double>& arrays) {
    auto& [positions, velocities, forces, memories, stresses] = *room;
    for (std::size_t n = 0; n < positions.size(); ++n)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto j = static_cast<Index>(i);
        positions[n][j] = body.rest_positions[n][j] + arrays.displacement[i][n];
        velocities[n][j] = arrays.velocity[i][n];
      }
    if (*step != nullptr) advance(body, **step, memories, positions, stresses);
    stresses_at(body, memories, positions, velocities, stresses);
    nodal_forces(body, stresses, positions, forces);
    for (std::size_t n = 0; n < forces.size(); ++n)
      for (std::size_t i = 0; i < 3; ++i)
        arrays.force[i][n] = forces[n][static_cast<Index>(i)];
  };
  return {.forces = {.lanes = 1, .add = add},
          .step = step,
          .memories = [room](const std::vector<Block>&) { return room->memories; }};
}

}  // namespace springcheck::mss
