#pragma once

#include "statics/systems/preconditioner.hpp"
#include "statics/systems/unknowns.hpp"

namespace springcheck::statics {

/// The inverses of the nodes' 3x3 blocks, of which negative eigenvalues count by their
/// size.
class BlockJacobi final : public Preconditioner {
 public:
  explicit BlockJacobi(const Unknowns& unknowns) : unknowns_(unknowns) {}

  void prepare(const BlockMatrix& matrix) override;
  [[nodiscard]] bool lasts() const override { return false; }
  [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& residual) const override;

 private:
  const Unknowns& unknowns_;
  std::vector<Matrix3> inverses_;
};

}  // namespace springcheck::statics
