#pragma once

#include "fem_reference/cells/discretisation.hpp"
#include "fem_reference/cells/nodal_patch_state.hpp"
#include "statics/elastic_body.hpp"

namespace springcheck::fem_reference {

/// The elements of a discretisation, as the search for equilibria sees them. Refers to
/// it.
class ElementsBody final : public statics::ElasticBody {
 public:
  ElementsBody(const Discretisation& body, const CellLaw& law);

  [[nodiscard]] std::span<const Vector3> nodes() const override { return body_.nodes; }
  [[nodiscard]] double cell_edge() const override;

  /// Whether the law is Hooke's.
  [[nodiscard]] bool is_linear() const override;

  /// The energy of any law but Hooke's is infinite where det F <= 0 at a Gauss point, or
  /// for the mean around a node.
  State state(const Eigen::VectorXd& displacements) override;

  /// The cells, and for q1_nodal the nodal patches behind them.
  [[nodiscard]] statics::Patches patches() const override;
  void linearise(const Eigen::VectorXd& displacements) override;
  [[nodiscard]] Eigen::MatrixXd part(std::size_t patch) const override;
  [[nodiscard]] Eigen::MatrixXd positive_part(std::size_t patch) const override;

  /// sqrt((1/V) int |H|^2 dV)
  [[nodiscard]] double mean_gradient(const Eigen::VectorXd& field) const override;

  [[nodiscard]] double largest_volume_ratio(
      const Eigen::VectorXd& displacements) const override;

  /// The rounding of the displacements, from which gradients are computed.
  [[nodiscard]] double rounding(const Eigen::VectorXd& displacements) const override;

  /// int det F dV of each cell [m^3].
  [[nodiscard]] std::vector<double> cell_volumes(
      const Eigen::VectorXd& displacements) const;

 private:
  [[nodiscard]] FromNodalPatches from_patches(const NodalPatchState& nodal_patches,
                                              std::size_t cell) const {
    return body_.nodal_patches.size() == 0 ? FromNodalPatches{}
                                           : nodal_patches.on_cells[cell];
  }
  [[nodiscard]] NodalPatchTangent nodal_patch(std::size_t patch) const;

  const Discretisation& body_;
  CellLaw law_;
  Eigen::VectorXd at_;               // where the tangent is taken
  NodalPatchState nodal_patches_{};  // there
};

}  // namespace springcheck::fem_reference
