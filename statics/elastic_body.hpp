#pragma once

#include <Eigen/Core>

#include "statics/systems/block_matrix.hpp"

namespace springcheck::statics {

/// A discrete body that has a strain energy, as the search for its equilibria sees it.
/// Vectors hold all components of its nodes, 3 node + component; displacements [m] count
/// from rest.
class ElasticBody {
 public:
  ElasticBody() = default;
  virtual ~ElasticBody() = default;
  ElasticBody(const ElasticBody&) = delete;
  ElasticBody& operator=(const ElasticBody&) = delete;

  [[nodiscard]] virtual std::span<const Vector3> nodes() const = 0;  // at rest [m]
  [[nodiscard]] virtual double cell_edge() const = 0;                // mean [m]

  /// Whether the tangent is constant; it is positive definite then.
  [[nodiscard]] virtual bool is_linear() const { return false; }

  struct State {
    double strain_energy;    // [J]; infinite where a cell is inside out and the law ends
    Eigen::VectorXd forces;  // on the nodes, minus the energy's gradient [N]
  };
  virtual State state(const Eigen::VectorXd& displacements) = 0;

  /// Nodes of each of the patches that the tangent is a sum over.
  [[nodiscard]] virtual Patches patches() const = 0;

  /// Takes the tangent, the energy's second derivative [N/m], at the displacements.
  virtual void linearise(const Eigen::VectorXd& displacements) = 0;

  /// A patch's part of the tangent taken last, in 3x3 blocks in the order of its nodes;
  /// and one without negative eigenvalues near it. May be called from several threads.
  [[nodiscard]] virtual Eigen::MatrixXd part(std::size_t patch) const = 0;
  [[nodiscard]] virtual Eigen::MatrixXd positive_part(std::size_t patch) const = 0;

  /// Root mean square of a displacement field's gradient.
  [[nodiscard]] virtual double mean_gradient(const Eigen::VectorXd& field) const = 0;

  /// Largest volume of a cell over that at rest.
  [[nodiscard]] virtual double largest_volume_ratio(
      const Eigen::VectorXd& displacements) const = 0;

  /// What rounding does to a node's place where forces are computed from it [m].
  [[nodiscard]] virtual double rounding(const Eigen::VectorXd& displacements) const = 0;
};

}  // namespace springcheck::statics
