#pragma once

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "meshing/generators/generate_block.hpp"
#include "statics/systems/block_matrix.hpp"

// Bodies of neither solver: springs of unit stiffness between all nodes of each cell.
namespace springcheck::statics {

inline constexpr double edge = 0.05;  // [m]

inline Mesh cube(int cells, CellPattern pattern = CellPattern::hexahedron) {
  return generate_block({.size = {edge, edge, edge},
                         .cells = {cells, cells, cells},
                         .pattern = pattern,
                         .distortion = 0.2});
}

inline Patches patches(const Mesh& mesh) {
  Patches patches;
  for (const CellNodes& cell : mesh.cells())
    patches.emplace_back(cell.begin(), cell.end());
  return patches;
}

/// sum of n n^T + pull (I - n n^T) over pairs of the nodes; 0 < pull < 1 as of stretched
/// springs, below zero as of compressed ones.
inline Eigen::MatrixXd part(const Mesh& mesh, std::size_t cell, double pull = 0) {
  const CellNodes& nodes = mesh.cells()[cell];
  const auto size = static_cast<Eigen::Index>(3 * nodes.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (std::size_t b = a + 1; b < nodes.size(); ++b) {
      const Vector3 n = (mesh.nodes()[nodes[b]] - mesh.nodes()[nodes[a]]).normalized();
      const Matrix3 block = (1 - pull) * n * n.transpose() + pull * Matrix3::Identity();
      const auto i = static_cast<Eigen::Index>(3 * a),
                 j = static_cast<Eigen::Index>(3 * b);
      sum.block<3, 3>(i, i) += block;
      sum.block<3, 3>(j, j) += block;
      sum.block<3, 3>(i, j) -= block;
      sum.block<3, 3>(j, i) -= block;
    }
  return sum;
}

inline void assemble(BlockMatrix& matrix, const Mesh& mesh, double pull = 0) {
  matrix.assemble([&](std::size_t cell) { return part(mesh, cell, pull); });
}

inline Eigen::MatrixXd dense(const Mesh& mesh, double pull = 0) {
  const auto size = 3 * std::ssize(mesh.nodes());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const CellNodes& nodes = mesh.cells()[c];
    const Eigen::MatrixXd of_cell = part(mesh, c, pull);
    for (std::size_t a = 0; a < nodes.size(); ++a)
      for (std::size_t b = 0; b < nodes.size(); ++b)
        sum.block<3, 3>(3 * nodes[a], 3 * nodes[b]) += of_cell.block<3, 3>(
            static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b));
  }
  return sum;
}

/// The bottom is held, and one component of the last node.
inline std::vector<bool> held_below(const Mesh& mesh) {
  std::vector<bool> is_free(3 * mesh.nodes().size(), true);
  for (const NodeIndex node : mesh.region("bottom").nodes)
    for (std::size_t i = 0; i < 3; ++i) is_free[3 * node + i] = false;
  is_free.back() = false;
  return is_free;
}

inline Eigen::VectorXd random_values(Eigen::Index size, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::VectorXd values(size);
  for (double& value : values) value = uniform(random);
  return values;
}

}  // namespace springcheck::statics
