#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

#include "fem_reference/solve.hpp"

namespace springcheck::fem_reference {

/// The discrete body: trilinear hexahedra with 2x2x2 Gauss points over the undeformed
/// mesh (cell.hpp), assembled by deal.II, and the factor of its tangent. Nodal vectors
/// hold three entries per node, dof = 3 node + component; some nodes are prescribed, the
/// others free.
class Elasticity {
 public:
  Elasticity(const Mesh& mesh, const Material& material, const Settings& settings,
             std::span<const NodeIndex> prescribed);
  ~Elasticity();
  Elasticity(const Elasticity&) = delete;
  Elasticity& operator=(const Elasticity&) = delete;

  struct Internal {
    double energy;             // W, the sum over the cells [J]
    Eigen::VectorXd forces;    // dW/du [N]
    double smallest_jacobian;  // of det F over the Gauss points
    double mean_gradient;      // sqrt((1/V) int |H|^2 dV)
  };
  [[nodiscard]] Internal internal(const Eigen::VectorXd& displacements) const;

  /// Consistent nodal forces of a uniform acceleration [N]: rho g int N_a dV.
  [[nodiscard]] Eigen::VectorXd weight(const Vector3& gravity) const;

  /// Assembles the tangent d2W/du2 and factors its free block as LL^T. False when that is
  /// not positive definite; then factor_indefinite() offers LDL^T of the same tangent
  /// (false when it is singular). step() needs a factor.
  bool factor(const Eigen::VectorXd& displacements);
  bool factor_indefinite();

  /// Negative eigenvalues of the tangent, after factor_indefinite().
  [[nodiscard]] int negative_eigenvalues() const;

  /// Displacement increment that equals `increment` on prescribed nodes and answers the
  /// unbalanced forces on free ones to first order:
  ///
  ///     K_ff d_f = unbalanced_f - K_fp increment_p
  [[nodiscard]] Eigen::VectorXd step(const Eigen::VectorXd& unbalanced,
                                     const Eigen::VectorXd& increment) const;

  /// The vector with its entries on prescribed nodes set to zero.
  [[nodiscard]] Eigen::VectorXd free_part(Eigen::VectorXd nodal) const;

  /// Size of the error that rounding leaves in the internal forces [N].
  [[nodiscard]] double round_off(const Eigen::VectorXd& displacements) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace springcheck::fem_reference
