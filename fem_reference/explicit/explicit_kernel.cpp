#include "fem_reference/explicit/explicit_kernel.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <memory>

#include "fem_reference/explicit/hexahedra.hpp"
#include "fem_reference/explicit/hexahedron_forces_paths.hpp"

namespace springcheck::fem_reference {
namespace {

using dynamics::Block;

/// The element of dynamics::BlockArrays that a slot of the block is.
std::size_t element(const Block& block, std::size_t slot, std::size_t lanes) {
  const std::size_t rows = block.nodes.size() / lanes;
  return slot % rows * lanes + slot / rows;
}

/// Calls visit(cell number, rest positions of its corners in the block's order).
template <class Visit>
void for_each_cell(const Mesh& mesh, const Block& block, const Visit& visit) {
  for (std::size_t cell = 0; cell < block.cells.size(); ++cell) {
    if (block.cells[cell] == dynamics::no_cell) continue;
    const auto slots = block.corner_slots(cell);
    CornerVectors rest;
    for (std::size_t c = 0; c < 8; ++c)
      rest.col(static_cast<Eigen::Index>(c)) = mesh.nodes()[block.nodes[slots[c]]];
    visit(cell, rest);
  }
}

/// Positions differ from those of a perfect grid by their rounding [m].
double rounding(const Mesh& mesh) {
  double reach = 0;
  for (const Vector3& x : mesh.nodes()) reach = std::max(reach, x.cwiseAbs().maxCoeff());
  return 8 * std::numeric_limits<double>::epsilon() * reach;
}

/// What the cells of a block have in common, and one of them.
struct Likeness {
  CellShapes shapes;
  CornerVectors cell;
  std::array<std::size_t, 3> axes{0, 1, 2};  // see HexahedronBlock
};

/// Columns are the edges that leave corner 0.
Eigen::Matrix3d edges(const CornerVectors& rest) {
  Eigen::Matrix3d edges;
  edges << rest.col(1) - rest.col(0), rest.col(2) - rest.col(0),
      rest.col(4) - rest.col(0);
  return edges;
}

Likeness likeness(const Mesh& mesh, const Block& block) {
  const double tolerance = rounding(mesh);
  Likeness like{.shapes = CellShapes::parallelepipeds, .cell = {}};
  bool is_first = true;
  for_each_cell(mesh, block, [&](std::size_t, const CornerVectors& rest) {
    if (is_first) like.cell = rest;
    is_first = false;
    const Eigen::Matrix3d common = edges(like.cell);
    for (std::size_t c = 0; c < 8; ++c) {
      const Vector3 place = (corner_place(c) + Vector3::Ones()) / 2;
      const Vector3 off =
          rest.col(static_cast<Eigen::Index>(c)) - rest.col(0) - common * place;
      if (off.cwiseAbs().maxCoeff() > tolerance) like.shapes = CellShapes::hexahedra;
    }
  });
  if (!block.is_grid()) like.shapes = CellShapes::hexahedra;
  if (like.shapes == CellShapes::hexahedra) return like;
  like.shapes = CellShapes::boxes;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vector3 edge = edges(like.cell).col(k).cwiseAbs();
    Eigen::Index along = 0;
    const double length = edge.maxCoeff(&along);
    like.axes[static_cast<std::size_t>(k)] = static_cast<std::size_t>(along);
    if (edge.sum() - length > tolerance) {
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
  HexahedronBlock<Real> cells{.row = block.row,
                              .layer = block.layer,
                              .corners = block.corners,
                              .cells = block.cells.size(),
                              .axes = like.axes,
                              .constants = {},
                              .half_lambda = static_cast<Real>(lambda / 2),
                              .mu = static_cast<Real>(mu)};
  for (auto& corners : cells.corners)
    for (std::uint32_t& corner : corners)
      corner = static_cast<std::uint32_t>(element(block, corner, lanes));
  const auto number = [&](std::size_t cell) {
    return block.is_grid() ? element(block, cell, lanes) : cell;
  };
  if (like.shapes != CellShapes::hexahedra) {
    for (const double constant : constants_of(like.cell))
      cells.constants.push_back(static_cast<Real>(constant));
    cells.is_cell.resize(cells.cells);
    for (std::size_t cell = 0; cell < cells.cells; ++cell)
      cells.is_cell[number(cell)] = block.cells[cell] == dynamics::no_cell ? 0 : 1;
    return cells;
  }
  for_each_cell(mesh, block, [&](std::size_t cell, const CornerVectors& rest) {
    const std::vector<double> constants = constants_of(rest);
    cells.constants.resize(constants.size() * cells.cells);
    for (std::size_t n = 0; n < constants.size(); ++n)
      cells.constants[n * cells.cells + number(cell)] = static_cast<Real>(constants[n]);
  });
  return cells;
}

template <class Real>
std::vector<Real> drag(const Mesh& mesh, const Block& block, double density, double rate,
                       std::size_t lanes) {
  std::vector<double> drag(block.nodes.size(), 0);
  for_each_cell(mesh, block, [&](std::size_t cell, const CornerVectors& rest) {
    const auto slots = block.corner_slots(cell);
    const auto volumes = corner_volumes(rest);
    for (std::size_t c = 0; c < 8; ++c)
      drag[element(block, slots[c], lanes)] += rate * density * volumes[c];
  });
  return {drag.begin(), drag.end()};
}

template <class Real>
HexahedronForces<Real> compiled(const HexahedronKind& kind,
                                dynamics::InstructionSet set) {
#if defined(__x86_64__)
  if (set == dynamics::InstructionSet::avx512)
    return avx512::hexahedron_forces(kind, Real{});
  if (set == dynamics::InstructionSet::avx2) return avx2::hexahedron_forces(kind, Real{});
#endif
  return portable::hexahedron_forces(kind, Real{});
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
  const auto kernels = std::make_shared<std::vector<Kernel<Real>>>();
  for (const Block& block : blocks) {
    const Likeness like = likeness(mesh, block);
    HexahedronBlock<Real> cells =
        hexahedron_block<Real>(mesh, block, material, element, like, lanes);
    if (drag_rate > 0)
      cells.drag = drag<Real>(mesh, block, material.density, drag_rate, lanes);
    kernels->push_back(
        {std::move(cells),
         compiled<Real>({.one_point = element == ExplicitElement::one_point,
                         .in_grid = block.is_grid(),
                         .shapes = like.shapes},
                        set)});
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
