#include "mss/tangent.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "mss/cell.hpp"

namespace springcheck::mss {
namespace {

void add_spring(CellMatrix& tangent, const LocalSpring& spring, double stiffness,
                double rest_length, const CornerPositions& x) {
  const Vector3 d = x.col(static_cast<Eigen::Index>(spring[1])) -
                    x.col(static_cast<Eigen::Index>(spring[0]));
  const double length = d.norm();
  if (length == 0) return;
  const Vector3 n = d / length;
  const double across = 1 - rest_length / length;
  const Eigen::Matrix3d block = stiffness * (across * Eigen::Matrix3d::Identity() +
                                             (1 - across) * n * n.transpose());
  const auto i = static_cast<Eigen::Index>(3 * spring[0]),
             j = static_cast<Eigen::Index>(3 * spring[1]);
  tangent.block<3, 3>(i, i) += block;
  tangent.block<3, 3>(j, j) += block;
  tangent.block<3, 3>(i, j) -= block;
  tangent.block<3, 3>(j, i) -= block;
}

}  // namespace

CellMatrix cell_tangent(const Cell& cell, double volume_modulus,
                        std::span<const Vector3> rest_positions,
                        std::span<const Vector3> positions) {
  const CornerPositions X = corners(cell.nodes, rest_positions),
                          x = corners(cell.nodes, positions);
  CellMatrix tangent = CellMatrix::Zero();
  const auto add = [&](const auto& pairs, double stiffness) {
    if (stiffness == 0) return;
    for (const LocalSpring& spring : pairs)
      add_spring(tangent, spring, stiffness, (X.col(static_cast<Eigen::Index>(spring[1])) -
                  X.col(static_cast<Eigen::Index>(spring[0])))
                     .norm(), x);
  };
  add(cell_edges, cell.share.edge);
  add(cell_face_diagonals, cell.share.face_diagonal);
  add(cell_inner_diagonals, cell.share.inner_diagonal);
  if (volume_modulus != 0) {
    const auto gradient = mean_edge_volume_gradient(x);
    const Eigen::Map<const Eigen::Matrix<double, 24, 1>> g(gradient.data());
    tangent += volume_modulus / cell.rest_volume *
               (g * g.transpose() +
                (mean_edge_volume(x) - cell.rest_volume) * mean_edge_volume_hessian(x));
  }
  return tangent;
}

std::vector<CellMatrix> cell_tangents(const Network& network,
                                      std::span<const Vector3> positions) {
  std::vector<CellMatrix> tangents(network.cells.size());
  tbb::parallel_for(std::size_t{0}, tangents.size(), [&](std::size_t c) {
    tangents[c] = cell_tangent(network.cells[c], network.volume_modulus,
                               network.rest_positions, positions);
  });
  return tangents;
}

void clamp_to_positive(std::vector<CellMatrix>& matrices) {
  tbb::parallel_for(std::size_t{0}, matrices.size(), [&](std::size_t c) {
    const Eigen::SelfAdjointEigenSolver<CellMatrix> spectrum(matrices[c]);
    const auto& vectors = spectrum.eigenvectors();
    matrices[c] =
        vectors * spectrum.eigenvalues().cwiseMax(0).asDiagonal() * vectors.transpose();
  });
}

FreeAssembly::FreeAssembly(const Network& network, const std::vector<bool>& is_free)
    : unknowns_(is_free.size(), -1) {
  Eigen::Index count = 0;
  for (std::size_t i = 0; i < is_free.size(); ++i)
    if (is_free[i]) unknowns_[i] = count++;

  std::vector<Eigen::Triplet<double>> entries;
  const auto for_each_entry = [&](const Cell& cell, auto&& visit) {
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < 8; ++j)
        for (int r = 0; r < 3; ++r)
          for (int s = 0; s < 3; ++s) {
            const Eigen::Index row = unknown(cell.nodes[i], r),
                               column = unknown(cell.nodes[j], s);
            visit(row, column, column >= 0 && row >= column);
          }
  };
  for (const Cell& cell : network.cells)
    for_each_entry(cell, [&](Eigen::Index row, Eigen::Index column, bool kept) {
      if (kept) entries.emplace_back(row, column, 0.0);
    });
  matrix_.resize(count, count);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  if (matrix_.nonZeros() > std::numeric_limits<std::int32_t>::max())
    throw std::length_error("tangent with more than 2^31 entries");

  places_.reserve(576 * network.cells.size());
  for (const Cell& cell : network.cells)
    for_each_entry(cell, [&](Eigen::Index row, Eigen::Index column, bool kept) {
      places_.push_back(kept ? static_cast<std::int32_t>(&matrix_.coeffRef(row, column) -
                                                         matrix_.valuePtr())
                             : -1);
    });
}

const Eigen::SparseMatrix<double>& FreeAssembly::assemble(
    const std::vector<CellMatrix>& matrices) {
  std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
  std::size_t entry = 0;
  for (const CellMatrix& cell : matrices)
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < 8; ++j)
        for (std::size_t r = 0; r < 3; ++r)
          for (std::size_t s = 0; s < 3; ++s)
            if (const std::int32_t place = places_[entry++]; place >= 0)
              matrix_.valuePtr()[place] += cell(static_cast<Eigen::Index>(3 * i + r),
                                                static_cast<Eigen::Index>(3 * j + s));
  return matrix_;
}

}  // namespace springcheck::mss
