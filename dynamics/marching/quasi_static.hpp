#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "dynamics/marching/march.hpp"

namespace springcheck::dynamics {

/// A body whose forces depend on what it remembers. Vectors hold one entry per node,
/// fields one per free component of the nodes, ascending.
class RememberingBody {
 public:
  RememberingBody() = default;
  virtual ~RememberingBody() = default;
  RememberingBody(const RememberingBody&) = delete;
  RememberingBody& operator=(const RememberingBody&) = delete;

  /// Load at the load fraction 1 [N].
  [[nodiscard]] virtual std::vector<Vector3> load() const = 0;

  /// Internal forces on the nodes [N] at the end of a step of dt [s] that leads to the
  /// positions; the memories stay.
  [[nodiscard]] virtual std::vector<Vector3> forces_after(
      double dt, std::span<const Vector3> positions) = 0;

  /// Norm of forces that cancel in those of the last call of forces_after, in the body at
  /// rest as well: what a residual is measured by [N].
  [[nodiscard]] virtual double force_scale() const = 0;

  /// Takes the symmetric part of the tangent there, minus the forces' derivative by the
  /// positions, made positive definite where it is not; whether it was. forces_after was
  /// called last with the same.
  virtual bool linearise(double dt, std::span<const Vector3> positions) = 0;

  /// The tangent taken last times displacements of all nodes [N], and its solution on the
  /// free components [m].
  [[nodiscard]] virtual std::vector<Vector3> stiffness_times(
      std::span<const Vector3> displacements) const = 0;
  [[nodiscard]] virtual Eigen::VectorXd solve(const Eigen::VectorXd& forces) = 0;

  /// The memories become those after the step.
  virtual void advance(double dt, std::span<const Vector3> positions) = 0;

  /// With the memories as they are [J].
  [[nodiscard]] virtual double free_energy(std::span<const Vector3> positions) const = 0;

  /// sqrt(tr C' - 3) where it is largest [-], C' = C/(det C)^(1/3): in simple shear the
  /// strain.
  [[nodiscard]] virtual double largest_shear_strain(
      std::span<const Vector3> positions) const = 0;

  [[nodiscard]] virtual int factorisations() const = 0;
};

/// So slowly that no inertia counts.
struct QuasiStaticSettings {
  LoadPath load;
  int steps;  // equal ones on each straight piece of the load
};

/// Moves a body through equilibria, one at the end of each step of time, in which its
/// memories are those after the step.
///
/// An equilibrium is found by Newton's method with the tangents of the body, from the
/// state that the tangent predicts for the supports' way; a step of the method is halved
/// until the residual falls, or where the tangent is not positive definite, or was not in
/// the equilibrium before, until the forces do not turn against it. Where an equilibrium
/// is not stable, the softest mode leads away from it, and to a stable one if there is
/// one near: a column buckles. Converged: the residual is below 1e-9 of the force scale.
/// A search that passed unstable states may have jumped to another branch, such as a
/// smaller turn of a plate: where it changes a displacement gradient by more than 1/2
/// from the prediction it counts as none.
///
/// A step of time that finds no equilibrium is halved, down to 1/64; then the status is
/// no_equilibrium if a jump was found, else not_converged, and the solution that of the
/// last state.
///
/// Each equilibrium is judged by the tangent of a further step in which nothing moves, a
/// twentieth of the time between the load's turning points, however long the steps are:
/// the more time the memories have to give way the earlier a body is not stable. Where
/// the tangent is not positive definite at the end, the status is indefinite;
/// definite_up_to is the load fraction of the last equilibrium before the first that is
/// not stable, or was left for one that is.
///
/// Observers are shown the moments that they ask for, as steps reach them; there are no
/// checkpoints. The solution has largest_shear_strain.
Solution find_quasi_static(const Mesh& mesh, const Scene& scene, RememberingBody& body,
                           const QuasiStaticSettings& settings,
                           const Observers& observers = {});

}  // namespace springcheck::dynamics
