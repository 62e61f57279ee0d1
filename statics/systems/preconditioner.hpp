#pragma once

#include "statics/systems/block_matrix.hpp"

namespace springcheck::statics {

/// An approximate inverse of a matrix, itself symmetric and positive definite. Vectors
/// hold all components and are zero at prescribed ones.
class Preconditioner {
 public:
  Preconditioner() = default;
  virtual ~Preconditioner() = default;
  Preconditioner(const Preconditioner&) = delete;
  Preconditioner& operator=(const Preconditioner&) = delete;

  virtual void prepare(const BlockMatrix& matrix) = 0;

  /// Whether it serves matrices near the one that it was prepared for.
  [[nodiscard]] virtual bool lasts() const = 0;

  [[nodiscard]] virtual Eigen::VectorXd times(const Eigen::VectorXd& residual) const = 0;
};

}  // namespace springcheck::statics
