#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck::statics {

/// The free ones of a body's components, 3 node + component, in their order. The others
/// are prescribed.
class Unknowns {
 public:
  /// is_free: one entry per component.
  explicit Unknowns(const std::vector<bool>& is_free);

  [[nodiscard]] Eigen::Index count() const {
    return static_cast<Eigen::Index>(components_.size());
  }
  [[nodiscard]] const std::vector<Eigen::Index>& components() const {
    return components_;
  }

  /// The unknown that a component is, -1 for a prescribed one.
  [[nodiscard]] Eigen::Index of(NodeIndex node, int component) const {
    return unknowns_[3 * std::size_t{node} + static_cast<std::size_t>(component)];
  }

  /// Their entries in a vector of all components, and a vector of all that has them, 0 at
  /// prescribed ones.
  [[nodiscard]] Eigen::VectorXd in(const Eigen::VectorXd& all) const {
    return all(components_);
  }
  [[nodiscard]] Eigen::VectorXd spread(const Eigen::VectorXd& free) const;

  /// Sets a vector's entries at prescribed components to zero.
  void clear_prescribed(Eigen::VectorXd& all) const { all(prescribed_).setZero(); }

 private:
  std::vector<Eigen::Index> components_, prescribed_;
  std::vector<Eigen::Index> unknowns_;
};

}  // namespace springcheck::statics
