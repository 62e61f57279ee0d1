#pragma once

#include <memory>
#include <span>

#include "statics/systems/preconditioner.hpp"
#include "statics/systems/unknowns.hpp"

namespace springcheck::statics {

/// A V-cycle of smoothed aggregation that knows the six rigid motions (Trilinos ML). What
/// it is prepared for must be positive definite.
///
/// Source: Vanek, Mandel and Brezina, Computing 56 (1996) 179.
class Multigrid final : public Preconditioner {
 public:
  /// nodes [m]. Refers to the unknowns.
  Multigrid(std::span<const Vector3> nodes, const Unknowns& unknowns);
  ~Multigrid() override;

  void prepare(const BlockMatrix& matrix) override;
  [[nodiscard]] bool lasts() const override { return true; }
  [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& residual) const override;

 private:
  struct Hierarchy;
  const Unknowns& unknowns_;
  Eigen::MatrixXd rigid_motions_;
  std::unique_ptr<Hierarchy> hierarchy_;
};

}  // namespace springcheck::statics
