#include "fem_reference/explicit/explicit_kernel.hpp"

#include <cmath>
#include <memory>

#include "fem_reference/explicit/hexahedra.hpp"
#include "fem_reference/explicit/hexahedron_forces_paths.hpp"

namespace springcheck::fem_reference {
namespace {

using dynamics::Block;

/// Rest positions of a cell's corners in the block's order.
CornerVectors rest_of(const Mesh& mesh, const Block& block,
                      const std::array<std::uint32_t, 8>& slots) {
  CornerVectors rest;
  for (std::size_t c = 0; c < 8; ++c)
    rest.col(static_cast<Eigen::Index>(c)) = mesh.nodes()[block.nodes[slots[c]]];
  return rest;
}

/// What the cells of a block have in common, and one of them.
struct Likeness {
  CellShapes shapes;
  CornerVectors cell{};
  std::array<std::size_t, 3> axes{0, 1, 2};  // see HexahedronBlock
};

Likeness likeness(const Mesh& mesh, const Block& block, double rounding) {
  const auto edges = dynamics::common_edges(block, mesh.nodes(), rounding);
  if (!edges) return {.shapes = CellShapes::hexahedra};
  Likeness like{.shapes = CellShapes::boxes};
  for (std::size_t c = 0; c < 8; ++c)
    like.cell.col(static_cast<Eigen::Index>(c)) =
        *edges * (corner_place(c) + Vector3::Ones()) / 2;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vector3 edge = edges->col(k).cwiseAbs();
    Eigen::Index along = 0;
    const double length = edge.maxCoeff(&along);
    like.axes[static_cast<std::size_t>(k)] = static_cast<std::size_t>(along);
    if (edge.sum() - length > rounding) {
      like.shapes = CellShapes::parallelepipeds;
      like.axes = {0, 1, 2};
      return like;
    }
  }
  return like;
}

/// See HexahedronBlock.
std::vector<double> one_point_constants(const CornerVectors& rest, double mu,
                                        const Likeness& like) {
  const OnePointCell cell = one_point_cell(rest);
  std::vector<double> constants{cell.volume};
  for (const double k : cell.hourglass_stiffness) constants.push_back(mu * k / 64);
  const auto b = [&](std::size_t s) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t a = 0; a < 8; ++a)
      sum +=
          mode(s, corner_place(a)) / 8 * cell.gradients.col(static_cast<Eigen::Index>(a));
    return sum;
  };
  const auto push = [&](const Vector3& v) {
    constants.insert(constants.end(), v.begin(), v.end());
  };
  switch (like.shapes) {
    case CellShapes::boxes:
      for (std::size_t k = 0; k < 3; ++k)
        constants.push_back(
            b(std::size_t{1} << k)[static_cast<Eigen::Index>(like.axes[k])]);
      break;
    case CellShapes::parallelepipeds:
      for (std::size_t k = 0; k < 3; ++k) push(b(std::size_t{1} << k));
      break;
    case CellShapes::hexahedra:
      for (const auto& y : cell.hourglass_position.colwise()) push(y);
      for (std::size_t s = 1; s < 7; ++s) push(b(s));  // the volume does not see mode 7
  }
  return constants;
}

/// See HexahedronBlock.
std::vector<double> eight_point_constants(const CornerVectors& rest,
                                          const Likeness& like) {
  const std::array<GaussPoint, 8> points = gauss_points(rest);
  std::vector<double> constants;
  const std::size_t count = like.shapes == CellShapes::hexahedra ? 8 : 1;
  for (std::size_t p = 0; p < count; ++p) {
    constants.push_back(points[p].volume);
    for (Eigen::Index k = 0; k < 3; ++k)
      for (Eigen::Index i = 0; i < 3; ++i)
        if (like.shapes != CellShapes::boxes ||
            i == static_cast<Eigen::Index>(like.axes[static_cast<std::size_t>(k)]))
          constants.push_back(points[p].inverse_jacobian(k, i));
  }
  return constants;
}

template <class Real>
HexahedronBlock<Real> hexahedron_block(const Mesh& mesh, const Block& block,
                                       const Material& material, ExplicitElement points,
                                       const Likeness& like, std::size_t lanes) {
  const auto [lambda, mu] = lame_constants(material);
  const auto constants_of = [&, mu = mu](const CornerVectors& rest) {
    return points == ExplicitElement::one_point ? one_point_constants(rest, mu, like)
                                                : eight_point_constants(rest, like);
  };
  HexahedronBlock<Real> cells{.cells = dynamics::cells_in_arrays(block, lanes),
                              .axes = like.axes,
                              .half_lambda = static_cast<Real>(lambda / 2),
                              .mu = static_cast<Real>(mu)};
  const std::size_t count = cells.cells.count;
  if (like.shapes != CellShapes::hexahedra) {
    for (const double constant : constants_of(like.cell))
      cells.constants.push_back(static_cast<Real>(constant));
    cells.is_cell.resize(count);
    dynamics::for_each_cell(block, [&](std::size_t cell, const auto&) {
      cells.is_cell[dynamics::number_of(block, cell, lanes)] = 1;
    });
    return cells;
  }
  dynamics::for_each_cell(block, [&](std::size_t cell, const auto& slots) {
    const std::vector<double> constants = constants_of(rest_of(mesh, block, slots));
    cells.constants.resize(constants.size() * count);
    for (std::size_t n = 0; n < constants.size(); ++n)
      cells.constants[n * count + dynamics::number_of(block, cell, lanes)] =
          static_cast<Real>(constants[n]);
  });
  return cells;
}

template <class Real>
std::vector<Real> drag(const Mesh& mesh, const Block& block, double density, double rate,
                       std::size_t lanes) {
  std::vector<double> drag(block.nodes.size(), 0);
  dynamics::for_each_cell(block, [&](std::size_t, const auto& slots) {
    const auto volumes = corner_volumes(rest_of(mesh, block, slots));
    for (std::size_t c = 0; c < 8; ++c)
      drag[dynamics::element_of(block, slots[c], lanes)] += rate * density * volumes[c];
  });
  return {drag.begin(), drag.end()};
}

template <class Real>
struct Kernel {
  HexahedronBlock<Real> block;
  HexahedronForces<Real> forces;
};

}  // namespace

template <class Real>
dynamics::BlockForces<Real> explicit_kernel(const Mesh& mesh, const Material& material,
                                            ExplicitElement element,
                                            const std::vector<Block>& blocks,
                                            double drag_rate,
                                            dynamics::InstructionSet set) {
  const std::size_t lanes = dynamics::lane_count<Real>(set);
  const double rounding = dynamics::rounding_of(mesh.nodes());
  const auto kernels = std::make_shared<std::vector<Kernel<Real>>>();
  for (const Block& block : blocks) {
    const Likeness like = likeness(mesh, block, rounding);
    HexahedronBlock<Real> cells =
        hexahedron_block<Real>(mesh, block, material, element, like, lanes);
    if (drag_rate > 0)
      cells.drag = drag<Real>(mesh, block, material.density, drag_rate, lanes);
    const HexahedronKind kind{.one_point = element == ExplicitElement::one_point,
                              .in_grid = block.is_grid(),
                              .shapes = like.shapes};
    kernels->push_back(
        {std::move(cells), SPRINGCHECK_ON_PATH(set, hexahedron_forces(kind, Real{}))});
  }
  return {.lanes = lanes,
          .add = [kernels](std::size_t b, const dynamics::BlockArrays<Real>& arrays) {
            (*kernels)[b].forces((*kernels)[b].block, arrays);
          }};
}

template dynamics::BlockForces<double> explicit_kernel(
    const Mesh& mesh, const Material& material, ExplicitElement element,
    const std::vector<Block>& blocks, double drag_rate, dynamics::InstructionSet set);
template dynamics::BlockForces<float> explicit_kernel(
    const Mesh& mesh, const Material& material, ExplicitElement element,
    const std::vector<Block>& blocks, double drag_rate, dynamics::InstructionSet set);

}  // namespace springcheck::fem_reference
