#pragma once

#include <vector>

#include "fem_reference/cells/discretisation.hpp"

namespace springcheck::fem_reference {

/// What the scene prescribes of a discretisation's dofs (3 node + component). An
/// intermediate node on a plate's face or edge is held as the plate holds its vertices,
/// and moves by their mean: plates are rigid.
class Supports {
 public:
  Supports(const Mesh& mesh, const Scene& scene, const Discretisation& body);

  /// One entry per dof; the others are prescribed.
  [[nodiscard]] const std::vector<bool>& is_free() const { return is_free_; }

  /// Prescribed displacements at a load fraction [m], 0 at free dofs.
  [[nodiscard]] Eigen::VectorXd displacements(double load_fraction) const;

 private:
  struct Intermediate {
    NodeIndex node;
    std::vector<NodeIndex> parents;
  };
  const Mesh& mesh_;
  const Scene& scene_;
  std::vector<PrescribedComponent> at_vertices_;
  std::vector<Intermediate> intermediate_;  // some component prescribed
  std::vector<bool> is_free_;
};

/// Nodal forces with those of intermediate nodes shared out among the vertices they lie
/// between: a rigid plate's resultant force and torque stay the same, because an
/// intermediate node lies at the mean of its vertices before and after the motion.
std::vector<Vector3> on_vertices(const Discretisation& body,
                                 const Eigen::VectorXd& nodal_forces);

}  // namespace springcheck::fem_reference
