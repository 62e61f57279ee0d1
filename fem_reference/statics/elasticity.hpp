#pragma once

#include <optional>

#include "fem_reference/statics/multigrid.hpp"
#include "fem_reference/statics/stiffness_matrix.hpp"

namespace springcheck::fem_reference {

/// The discrete body: its energy, forces and tangent, and the solver of its linear
/// systems. Nodal vectors hold three entries per node, dof = 3 node + component; some
/// dofs are prescribed, the others free. Refers to the discretisation and the flags it
/// was made from.
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

  /// Whether the tangent is positive definite: by its Cholesky factor, or probed by
  /// Multigrid::probe().
  [[nodiscard]] bool is_definite();

  /// Prepares step() for the tangent as it is, definite or not. False when it is
  /// singular.
  bool accept_indefinite();

  /// Negative eigenvalues of a tangent that is not positive definite, after
  /// accept_indefinite(): exact with the direct solver, by Multigrid::probe() otherwise.
  [[nodiscard]] int negative_eigenvalues() const { return negative_eigenvalues_; }

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

  /// Iterations of multigrid so far; none with the direct solver.
  [[nodiscard]] std::optional<int> linear_iterations() const;

  /// Factorisations so far; none with multigrid.
  [[nodiscard]] std::optional<int> factorisations() const;

 private:
  enum class Definiteness { unknown, definite, indefinite, indefinite_accepted };

  [[nodiscard]] Eigen::VectorXd forces_of(const Eigen::VectorXd& increment) const;
  [[nodiscard]] std::optional<Eigen::VectorXd> solved(const Eigen::VectorXd& right);

  const Discretisation& body_;
  const std::vector<bool>& prescribed_;
  CellLaw law_;
  StiffnessMatrix stiffness_;
  DirectSolver direct_;
  std::optional<Multigrid> multigrid_;  // none: the direct solver
  Eigen::VectorXd linearised_at_;
  Definiteness definiteness_ = Definiteness::unknown;
  int negative_eigenvalues_ = 0;
  int iterations_ = 0;
  int iterations_when_fresh_ = 0;
  bool preconditioner_is_fresh_ = false;
};

}  // namespace springcheck::fem_reference
