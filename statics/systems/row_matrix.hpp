#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/SparseCore>

namespace springcheck::statics {

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The product, made in parallel, to the same bits on any number of threads.
inline Eigen::VectorXd product(const RowMatrix& matrix, const Eigen::VectorXd& x) {
  Eigen::VectorXd result(matrix.rows());
  const int* const start = matrix.outerIndexPtr();
  const int* const columns = matrix.innerIndexPtr();
  const double* const values = matrix.valuePtr();
  tbb::parallel_for(tbb::blocked_range<Eigen::Index>(0, matrix.rows(), 512),
                    [&](const tbb::blocked_range<Eigen::Index>& rows) {
                      for (Eigen::Index row = rows.begin(); row < rows.end(); ++row) {
                        double sum = 0;
                        for (int k = start[row]; k < start[row + 1]; ++k)
                          sum += values[k] * x[columns[k]];
                        result[row] = sum;
                      }
                    });
  return result;
}

}  // namespace springcheck::statics
