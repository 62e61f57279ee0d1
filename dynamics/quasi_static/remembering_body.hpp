#pragma once

#include <span>
#include <vector>

#include "meshing/basics/vector3.hpp"
#include "statics/systems/block_matrix.hpp"

namespace springcheck::dynamics {

/// A body whose forces depend on what it remembers. Vectors hold one entry per node.
class RememberingBody {
 public:
  struct Forces {
    std::vector<Vector3> on_nodes;  // internal ones [N]
    // Norm of forces that cancel in them, in the body at rest as well: what a residual is
    // measured by [N].
    double scale;
  };

  RememberingBody() = default;
  virtual ~RememberingBody() = default;
  RememberingBody(const RememberingBody&) = delete;
  RememberingBody& operator=(const RememberingBody&) = delete;

  /// Load at the load fraction 1 [N].
  [[nodiscard]] virtual std::vector<Vector3> load() const = 0;

  /// The patches of the tangent: the nodes of each cell.
  [[nodiscard]] virtual statics::Patches patches() const = 0;

  /// The forces at the end of a step of dt [s] that leads to the positions [m]; the
  /// memories stay as they are.
  [[nodiscard]] virtual Forces forces_after(double dt,
                                            std::span<const Vector3> positions) = 0;

  /// Assembles the symmetric part of the tangent there, minus the forces' derivative by
  /// the positions [N/m]. forces_after must have been called last with the same
  /// arguments.
  virtual void assemble_tangent(double dt, std::span<const Vector3> positions,
                                statics::BlockMatrix& tangent) = 0;

  /// Makes the memories those after the step. forces_after must have been called last
  /// with the same arguments.
  virtual void advance(double dt, std::span<const Vector3> positions) = 0;

  /// The free energy with the memories as they are [J].
  [[nodiscard]] virtual double free_energy(std::span<const Vector3> positions) const = 0;

  /// sqrt(tr C' - 3) where it is largest [-], C' = C/(det C)^(1/3): in simple shear the
  /// strain.
  [[nodiscard]] virtual double largest_shear_strain(
      std::span<const Vector3> positions) const = 0;
};

}  // namespace springcheck::dynamics
