#pragma once

#include "mss/forces/tangent.hpp"
#include "statics/elastic_body.hpp"
#include "statics/loading.hpp"

namespace springcheck::mss {

/// A network as the search for equilibria sees it. Refers to the network.
class NetworkBody final : public statics::ElasticBody {
 public:
  explicit NetworkBody(const Network& network);

  [[nodiscard]] std::span<const Vector3> nodes() const override;
  [[nodiscard]] double cell_edge() const override;
  State state(const Eigen::VectorXd& displacements) override;
  [[nodiscard]] statics::Patches patches() const override;
  void linearise(const Eigen::VectorXd& displacements) override;
  [[nodiscard]] Eigen::MatrixXd part(std::size_t patch) const override;
  [[nodiscard]] Eigen::MatrixXd positive_part(std::size_t patch) const override;

  /// The root mean square of |change of d|/L over springs and damped edges.
  [[nodiscard]] double mean_gradient(const Eigen::VectorXd& field) const override;

  [[nodiscard]] double largest_volume_ratio(
      const Eigen::VectorXd& displacements) const override;

  /// The rounding of the positions, from which lengths of springs are computed.
  [[nodiscard]] double rounding(const Eigen::VectorXd& displacements) const override;

 private:
  [[nodiscard]] std::vector<Vector3> positions(
      const Eigen::VectorXd& displacements) const;

  const Network& network_;
  Tangent tangent_;
  CellStates states_;  // room for state()
};

/// What a scene drives a network by; refers to the mesh and the scene.
statics::Loading loading(const Mesh& mesh, const Scene& scene, const Network& network);

}  // namespace springcheck::mss
