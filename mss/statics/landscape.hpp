#pragma once

#include <optional>
#include <random>
#include <vector>

#include "mss/forces/cell_forces.hpp"
#include "mss/forces/tangent.hpp"
#include "statics/systems/system.hpp"

namespace springcheck::mss {

using Positions = std::vector<Vector3>;  // [m], one per node

/// Largest step of the load on the way to an equilibrium, by Landscape::gradient.
inline constexpr double gradient_per_step = 0.06;

/// Of all components.
double norm(const std::vector<Vector3>& vectors);

/// The total energy of a body at a load fraction, over its free displacement components:
/// values, forces, and its tangent, solved with directly or iteratively. Refers to the
/// mesh, scene and network it was made from. Vectors of unknowns hold one entry per free
/// component.
class Landscape {
 public:
  Landscape(const Mesh& mesh, const Scene& scene, const Network& network,
            statics::LinearSolver linear_solver);

  [[nodiscard]] double cell_edge() const { return cell_edge_; }  // mean [m]
  [[nodiscard]] int evaluations() const { return evaluations_; }
  [[nodiscard]] Eigen::Index unknowns() const { return system_.unknowns().count(); }
  [[nodiscard]] const std::vector<PrescribedComponent>& prescribed() const {
    return prescribed_;
  }

  void set_load(double load_fraction) { load_fraction_ = load_fraction; }

  /// Strain energy minus the work of gravity and tractions [J].
  [[nodiscard]] double energy(const Positions& x) const;

  /// Forces of springs, correction, gravity and tractions on every node [N].
  const std::vector<Vector3>& forces(const Positions& x);

  /// What the rounding of the positions x does to the forces' norm [N] and, at the given
  /// energy, to the energy [J]. A body that is hardly strained has little else.
  [[nodiscard]] double force_round_off(const Positions& x) const;
  [[nodiscard]] double energy_round_off(const Positions& x, double energy) const;

  /// Entries of the free components; x with them moved by factor * `by`; the longest way
  /// that such a step moves a node [m].
  [[nodiscard]] Eigen::VectorXd on_free(const std::vector<Vector3>& all) const;
  [[nodiscard]] Positions moved(const Positions& x, const Eigen::VectorXd& by,
                                double factor) const;
  [[nodiscard]] double longest_move(const Eigen::VectorXd& step) const;

  /// Takes the true tangent at x.
  void linearise(const Positions& x);

  /// Whether the tangent taken last is positive definite. None where the iterative solver
  /// gave up before it could tell.
  [[nodiscard]] std::optional<bool> is_definite(std::mt19937_64& random);

  /// Sets the negative eigenvalues of each patch of that tangent to zero.
  void clamp();

  /// Solves with that tangent; iteratively to the accuracy, relative to the right-hand
  /// side. None where it was found not to be positive definite.
  [[nodiscard]] std::optional<Eigen::VectorXd> solve(const Eigen::VectorXd& right,
                                                     double accuracy);

  /// Unit vector of negative curvature of that tangent, which must not be positive
  /// definite. Points downhill.
  [[nodiscard]] Eigen::VectorXd negative_curvature(const Eigen::VectorXd& downhill,
                                                   std::mt19937_64& random);

  /// d . K d of that tangent, d a unit vector [N/m].
  [[nodiscard]] double curvature_along(const Eigen::VectorXd& direction) const;

  /// x with the supports at load fraction `to`, the free components answering their
  /// increments and the load's to first order through that tangent, clamped where it is
  /// not positive definite.
  [[nodiscard]] Positions predicted(const Positions& x, double to);

  /// Iterations of the linear solver so far; none if it is direct.
  [[nodiscard]] std::optional<int> linear_iterations() const;

  /// Factorisations so far; none if the linear solver is iterative.
  [[nodiscard]] std::optional<int> factorisations() const;

  /// Linear systems that the limit of iterations left less accurate than was asked.
  [[nodiscard]] int truncated() const { return system_.truncated(); }

  /// Root mean square over springs and damped edges of |change of d|/L: about the
  /// displacement gradient between two states.
  [[nodiscard]] double gradient(const Positions& from, const Positions& to) const;

  /// The same of the whole path from rest, where the tangent is taken, to the state that
  /// it predicts for the full load: of its chord, or of its length where that is longer,
  /// since supports turn.
  [[nodiscard]] double path_gradient(const Positions& rest, const Positions& whole);

  /// Largest volume of a cell over its rest volume.
  [[nodiscard]] double largest_volume_ratio(const Positions& x) const;

 private:
  void assemble();

  const Mesh& mesh_;
  const Scene& scene_;
  const Network& network_;
  std::vector<PrescribedComponent> prescribed_;
  std::vector<Vector3> load_;  // [N] of the full load, on every node
  double cell_edge_;
  statics::System system_;
  double stiffness_;  // norm of the tangent's diagonal at rest [N/m]
  std::vector<Vector3> forces_;
  CellStates states_;  // room for forces()
  Tangent tangent_;
  double load_fraction_ = 0;
  int evaluations_ = 0;
};

}  // namespace springcheck::mss
