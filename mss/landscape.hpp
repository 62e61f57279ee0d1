#pragma once

#include <Eigen/CholmodSupport>
#include <random>
#include <vector>

#include "mss/network.hpp"
#include "mss/tangent.hpp"

namespace springcheck::mss {

using Positions = std::vector<Vector3>;  // [m], one per node

/// The total energy of a body at a load fraction, over its free nodes: values, forces,
/// and the Cholesky factor of its tangent. Refers to the scene and network it was made
/// from. Vectors over the free nodes hold three entries per free node.
class Landscape {
 public:
  Landscape(const Mesh& mesh, const Scene& scene, const Network& network);

  [[nodiscard]] double cell_edge() const { return cell_edge_; }  // mean [m]
  [[nodiscard]] int evaluations() const { return evaluations_; }
  [[nodiscard]] const std::vector<PrescribedNode>& prescribed() const {
    return prescribed_;
  }

  void set_load(double load_fraction) { load_fraction_ = load_fraction; }

  /// Strain energy minus the work of gravity [J].
  [[nodiscard]] double energy(const Positions& x) const;

  /// Forces of springs, correction and gravity on every node [N].
  const std::vector<Vector3>& forces(const Positions& x);

  /// What the rounding of the positions x does to the forces' norm [N] and, at the given
  /// energy, to the energy [J]. A body that is hardly strained has little else.
  [[nodiscard]] double force_round_off(const Positions& x) const;
  [[nodiscard]] double energy_round_off(const Positions& x, double energy) const;

  /// Entries of the free nodes; x with its free nodes moved by factor * `by`.
  [[nodiscard]] Eigen::VectorXd on_free(const std::vector<Vector3>& all) const;
  [[nodiscard]] Positions moved(const Positions& x, const Eigen::VectorXd& by,
                                double factor) const;

  /// Factors the true tangent at x; false when it is not positive definite.
  bool factor(const Positions& x);

  /// Factors the tangent of the last factor() with the negative eigenvalues of each cell
  /// set to zero; shifted when that is singular.
  void factor_clamped();

  /// Solves with the matrix factored last.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right);

  /// Unit vector of the most negative curvature of the last factor()'s tangent, which
  /// must not be positive definite, by inverse iteration on the tangent shifted just far
  /// enough. Points downhill.
  [[nodiscard]] Eigen::VectorXd negative_curvature(const Eigen::VectorXd& downhill,
                                                   std::mt19937_64& random);

  /// x with the plates at load fraction `to`, the free nodes answering their increments
  /// and the load's to first order through the tangent factored last.
  [[nodiscard]] Positions predicted(const Positions& x, double to);

  /// Root mean square over the springs of |change of d|/L: about the displacement
  /// gradient between two states.
  [[nodiscard]] double gradient(const Positions& from, const Positions& to) const;

  /// Largest volume of a cell over its rest volume.
  [[nodiscard]] double largest_volume_ratio(const Positions& x) const;

 private:
  [[nodiscard]] bool is_free(NodeIndex node) const {
    return assembly_.unknown(node) >= 0;
  }
  bool factor_matrix(const Eigen::SparseMatrix<double>& matrix);
  void factor_shifted(Eigen::SparseMatrix<double> matrix);

  const Scene& scene_;
  const Network& network_;
  std::vector<PrescribedNode> prescribed_;
  FreeAssembly assembly_;
  double cell_edge_;
  double stiffness_;  // norm of the tangent's diagonal at rest [N/m]
  std::vector<Vector3> forces_;
  std::vector<CellMatrix> tangents_;
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky_;
  bool analysed_ = false;
  double load_fraction_ = 0;
  int evaluations_ = 0;
};

}  // namespace springcheck::mss
