#pragma once

#include <Eigen/SparseCholesky>
#include <optional>

#include "fem_reference/cells/discretisation.hpp"
#include "statics/systems/system.hpp"

namespace springcheck::fem_reference {

/// The discrete body: its energy, forces and tangent, and the solver of its linear
/// systems. Nodal vectors hold three entries per node, dof = 3 node + component; some
/// dofs are prescribed, the others free. Refers to the discretisation that it was made
/// from.
class Elasticity {
 public:
  /// prescribed: one entry per dof.
  Elasticity(const Discretisation& body, const Material& material,
             const Settings& settings, const std::vector<bool>& prescribed);

  /// Hooke: the tangent is constant and positive definite.
  [[nodiscard]] bool is_linear() const;

  struct Internal {
    double energy;             // W, the sum over the cells [J]
    Eigen::VectorXd forces;    // dW/du [N]
    double smallest_jacobian;  // of det F over the Gauss points
    double mean_gradient;      // sqrt((1/V) int |H|^2 dV)
  };
  [[nodiscard]] Internal internal(const Eigen::VectorXd& displacements) const;

  /// int det F dV of each cell [m^3].
  [[nodiscard]] std::vector<double> cell_volumes(
      const Eigen::VectorXd& displacements) const;

  /// Assembles the tangent d2W/du2 at the displacements. False when the linear solver
  /// sees at once that it is not positive definite: the direct one does, multigrid does
  /// not.
  bool linearise(const Eigen::VectorXd& displacements);

  /// Whether the tangent is positive definite: by its Cholesky factor, or by
  /// statics::IterativeSolver::is_definite.
  [[nodiscard]] bool is_definite();

  /// Prepares step() for the tangent as it is, definite or not. False when it is
  /// singular.
  bool accept_indefinite();

  /// Negative eigenvalues of a tangent that is not positive definite, after
  /// accept_indefinite(); the direct solver alone knows.
  [[nodiscard]] std::optional<int> negative_eigenvalues() const {
    return negative_eigenvalues_;
  }

  /// Displacement increment that equals `increment` on prescribed dofs and answers the
  /// unbalanced forces on free ones to first order:
  ///
  ///     K_ff d_f = unbalanced_f - K_fp increment_p
  ///
  /// None when the linear solver fails or meets negative curvature.
  [[nodiscard]] std::optional<Eigen::VectorXd> step(const Eigen::VectorXd& unbalanced,
                                                    const Eigen::VectorXd& increment);

  /// The vector with its entries on prescribed dofs set to zero.
  [[nodiscard]] Eigen::VectorXd free_part(Eigen::VectorXd nodal) const;

  /// Size of the error that rounding leaves in the internal forces [N].
  [[nodiscard]] double round_off(const Eigen::VectorXd& displacements) const;

  /// Iterations of the linear solver so far; none with the direct one.
  [[nodiscard]] std::optional<int> linear_iterations() const;

  /// Factorisations so far; none with an iterative solver.
  [[nodiscard]] std::optional<int> factorisations() const;

 private:
  enum class Definiteness { unknown, definite, indefinite, indefinite_accepted };

  [[nodiscard]] std::optional<Eigen::VectorXd> solved(const Eigen::VectorXd& right);
  [[nodiscard]] std::optional<Eigen::VectorXd> solved_indefinite(
      const Eigen::VectorXd& right);

  const Discretisation& body_;
  CellLaw law_;
  statics::LinearSolver solver_;
  statics::System system_;
  // L D L^T without pivoting, slower than Cholesky's, of tangents that are not definite:
  std::optional<statics::FreeTriangle> triangle_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> indefinite_;
  Definiteness definiteness_ = Definiteness::unknown;
  std::optional<int> negative_eigenvalues_;
  double largest_diagonal_ = 0;
  int indefinite_effort_ = 0;  // factorisations or iterations with such tangents
};

}  // namespace springcheck::fem_reference
