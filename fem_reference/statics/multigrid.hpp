#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fem_reference/statics/direct_solver.hpp"
#include "meshing/mesh.hpp"

namespace springcheck::fem_reference {

/// Krylov solver for symmetric matrices of elasticity, three dofs a node, preconditioned
/// by smoothed aggregation (Trilinos ML through deal.II) that knows the six rigid
/// motions. The hierarchy is that of the matrix given to precondition(), which must be
/// positive definite, and serves nearby matrices too.
///
/// Source: Vanek, Mandel and Brezina, Computing 56 (1996) 179.
class Multigrid {
 public:
  /// nodes [m], one per three dofs; `prescribed` dofs have rows and columns of the
  /// identity (scaled).
  Multigrid(std::span<const Vector3> nodes, const std::vector<bool>& prescribed);
  ~Multigrid();
  Multigrid(const Multigrid&) = delete;
  Multigrid& operator=(const Multigrid&) = delete;

  void precondition(const SparseMatrix& matrix);
  [[nodiscard]] bool has_preconditioner() const;

  struct Answer {
    Eigen::VectorXd solution;
    int iterations;
    bool converged;
    int negative_curvatures;  // met on the way; above 0 the matrix is not definite
  };

  /// Conjugate gradients until the residual is below `tolerance` of the right-hand side.
  /// Stops at the first direction of negative curvature.
  [[nodiscard]] Answer solve_definite(const SparseMatrix& matrix,
                                      const Eigen::VectorXd& right,
                                      double tolerance) const;

  /// MINRES, for matrices that need not be definite.
  [[nodiscard]] Answer solve_indefinite(const SparseMatrix& matrix,
                                        const Eigen::VectorXd& right,
                                        double tolerance) const;

  /// Whether the matrix has negative eigenvalues: conjugate gradients from a random (but
  /// always the same) right-hand side; by Sylvester's law the Lanczos matrix they build
  /// has as many negative eigenvalues as there are negative curvatures. Run until the
  /// residual has fallen by 1e-4, when every eigenvector has been resolved to about that;
  /// an isolated negative eigenvalue is the first thing they find. Of equal eigenvalues
  /// they see one, and in a long run rounding lets them see one twice: the number is
  /// exact only when few and different.
  [[nodiscard]] Answer probe(const SparseMatrix& matrix) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace springcheck::fem_reference
