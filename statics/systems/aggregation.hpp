#pragma once

#include <vector>

#include "statics/systems/row_matrix.hpp"

namespace springcheck::statics {

/// Matrices from the finest to the coarsest, and between each and the next the
/// prolongation P from there: A_coarser = P^T A P.
struct Aggregation {
  std::vector<RowMatrix> matrices, prolongations;
};

/// Smoothed aggregation (Trilinos ML) of a symmetric matrix with three rows a node, down
/// to 2000 rows; near_null_space: motions that it hardly resists, as columns. One call at
/// a time in the whole process. Source: Vanek, Mandel and Brezina, Computing 56 (1996)
/// 179.
Aggregation aggregation(RowMatrix matrix, const Eigen::MatrixXd& near_null_space);

}  // namespace springcheck::statics
