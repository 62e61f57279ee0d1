#pragma once

#include <Eigen/CholmodSupport>
#include <random>
#include <vector>

#include "mss/assembly.hpp"
#include "mss/cell_forces.hpp"

namespace springcheck::mss {

using Positions = std::vector<Vector3>;  // [m], one per node

/// The total energy of a body at a load fraction, over its free displacement components:
/// values, forces, and the Cholesky factor of its tangent. Refers to the mesh, scene and
/// network it was made from. Vectors of unknowns hold one entry per free component.
class Landscape {
 public:
  Landscape(const Mesh& mesh, const Scene& scene, const Network& network);

  [[nodiscard]] double cell_edge() const { return cell_edge_; }  // mean [m]
  [[nodiscard]] int evaluations() const { return evaluations_; }
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

  /// Factors the true tangent at x; false when it is not positive definite.
  bool factor(const Positions& x);

  /// Factors the tangent of the last factor() with the negative eigenvalues of each patch
  /// set to zero; shifted when that is singular.
  void factor_clamped();

  /// Solves with the matrix factored last.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right);

  /// Unit vector of the most negative curvature of the last factor()'s tangent, which
  /// must not be positive definite, by inverse iteration on the tangent shifted just far
  /// enough. Points downhill.
  [[nodiscard]] Eigen::VectorXd negative_curvature(const Eigen::VectorXd& downhill,
                                                   std::mt19937_64& random);

  /// x with the supports at load fraction `to`, the free components answering their
  /// increments and the load's to first order through the tangent factored last.
  [[nodiscard]] Positions predicted(const Positions& x, double to);

  /// Root mean square over springs and damped edges of |change of d|/L: about the
  /// displacement gradient between two states.
  [[nodiscard]] double gradient(const Positions& from, const Positions& to) const;

  /// Largest volume of a cell over its rest volume.
  [[nodiscard]] double largest_volume_ratio(const Positions& x) const;

 private:
  /// visit(node, component, unknown) of every free component.
  template <class Visit>
  void for_each_free(Visit&& visit) const {
    for (NodeIndex n = 0; n < forces_.size(); ++n)
      for (int i = 0; i < 3; ++i)
        if (const Eigen::Index unknown = assembly_.unknown(n, i); unknown >= 0)
          visit(n, i, unknown);
  }
  bool factor_matrix(const Eigen::SparseMatrix<double>& matrix);
  void factor_shifted(Eigen::SparseMatrix<double> matrix);

  const Mesh& mesh_;
  const Scene& scene_;
  const Network& network_;
  std::vector<PrescribedComponent> prescribed_;
  std::vector<Vector3> load_;  // [N] of the full load, on every node
  FreeAssembly assembly_;
  double cell_edge_;
  double stiffness_;  // norm of the tangent's diagonal at rest [N/m]
  std::vector<Vector3> forces_;
  CellStates states_;  // room for forces()
  Tangent tangent_;
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky_;
  bool analysed_ = false;
  double load_fraction_ = 0;
  int evaluations_ = 0;
};

}  // namespace springcheck::mss
