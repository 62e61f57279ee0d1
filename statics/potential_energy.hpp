#pragma once

#include <optional>
#include <random>

#include "statics/elastic_body.hpp"
#include "statics/loading.hpp"
#include "statics/systems/system.hpp"

namespace springcheck::statics {

/// First step of the load on the way to an equilibrium, by mean_gradient: 20 %
/// compression begins with about a quarter of the load, 5 % is one step.
inline constexpr double first_gradient = 0.06;

/// The total energy of a body at a load fraction, over its unknowns: values, forces, and
/// its tangent, solved with directly or iteratively. Refers to the body and its loading.
/// States are displacements of all components; steps, directions and what is solved for
/// hold the unknowns.
class PotentialEnergy {
 public:
  PotentialEnergy(ElasticBody& body, const Loading& loading, LinearSolver linear_solver);

  [[nodiscard]] const ElasticBody& body() const { return body_; }
  [[nodiscard]] const Unknowns& unknowns() const { return system_.unknowns(); }
  [[nodiscard]] int evaluations() const { return evaluations_; }

  void set_load(double load_fraction) { load_fraction_ = load_fraction; }

  [[nodiscard]] double load_norm() const;  // [N]

  struct State {
    Eigen::VectorXd displacements;
    double energy;           // strain energy minus the work of the load [J]
    double strain_energy;    // [J]
    Eigen::VectorXd forces;  // the body's and the load's, on all components [N]
  };
  State at(Eigen::VectorXd u);

  /// What the supports push with in a state [N], 0 on unknowns.
  [[nodiscard]] Eigen::VectorXd reactions(const State& state) const;

  /// What rounding does to the norm of the forces [N] and, at the given energy, to the
  /// energy [J]. A body that is hardly strained has little else. Nothing before a tangent
  /// was taken.
  [[nodiscard]] double force_round_off(const Eigen::VectorXd& u) const;
  [[nodiscard]] double energy_round_off(const Eigen::VectorXd& u, double energy) const;

  /// u with a step of the unknowns added; the longest way that such a step moves a node
  /// [m].
  [[nodiscard]] Eigen::VectorXd moved(const Eigen::VectorXd& u,
                                      const Eigen::VectorXd& step) const;
  [[nodiscard]] double longest_move(const Eigen::VectorXd& step) const;

  /// Takes the true tangent at u.
  void linearise(const Eigen::VectorXd& u);

  /// Whether the tangent taken last is positive definite. None where the iterative solver
  /// gave up before it could tell.
  [[nodiscard]] std::optional<bool> is_definite(std::mt19937_64& random);

  /// Sets the negative eigenvalues of each patch of that tangent to zero.
  void clamp();
  [[nodiscard]] bool is_clamped() const { return is_clamped_; }

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

  /// u with the supports at load fraction `to`, the unknowns answering their increments
  /// and the load's to first order through that tangent, clamped where it is not positive
  /// definite.
  [[nodiscard]] Eigen::VectorXd predicted(const Eigen::VectorXd& u, double to);

  /// mean_gradient of the whole path from rest, where the tangent is taken, to the state
  /// `whole` that it predicts for the full load: of its chord, or of its length where
  /// that is longer, since supports turn.
  [[nodiscard]] double path_gradient(const Eigen::VectorXd& whole);

  /// Iterations of the linear solver so far; none if it is direct.
  [[nodiscard]] std::optional<int> linear_iterations() const {
    return system_.iterations();
  }

  /// Factorisations so far; none if the linear solver is iterative.
  [[nodiscard]] std::optional<int> factorisations() const {
    return system_.factorisations();
  }

  /// Linear systems that the limit of iterations left less accurate than was asked.
  [[nodiscard]] int truncated() const { return system_.truncated(); }

 private:
  ElasticBody& body_;
  const Loading& loading_;
  System system_;
  double stiffness_ = 0;  // norm of a tangent's diagonal, the largest so far [N/m]
  bool is_prepared_ = false, is_clamped_ = false;
  double load_fraction_ = 0;
  int evaluations_ = 0;
};

}  // namespace springcheck::statics
