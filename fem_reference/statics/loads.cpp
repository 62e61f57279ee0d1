#include "fem_reference/statics/loads.hpp"

namespace springcheck::fem_reference {

Eigen::VectorXd body_load(const Discretisation& body,
                          const std::function<Vector3(const Vector3&)>& density) {
  Eigen::VectorXd load =
      Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(body.nodes.size()));
  for (const Cell& cell : body.cells) {
    const Eigen::MatrixXd& values = *cell.shape->values;
    for (Eigen::Index q = 0; q < values.rows(); ++q) {
      Vector3 place = Vector3::Zero();
      for (std::size_t a = 0; a < cell.nodes.size(); ++a)
        place += values(q, static_cast<Eigen::Index>(a)) * body.nodes[cell.nodes[a]];
      const Vector3 force = cell.shape->weights[q] * density(place);
      for (std::size_t a = 0; a < cell.nodes.size(); ++a)
        load.segment<3>(3 * cell.nodes[a]) +=
            values(q, static_cast<Eigen::Index>(a)) * force;
    }
  }
  return load;
}

Eigen::VectorXd traction_load(const Discretisation& body, const Traction& traction) {
  Eigen::VectorXd load =
      Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(body.nodes.size()));
  for (const auto& [node, area] : body.regions.at(traction.region))
    load.segment<3>(3 * node) += area * traction.stress;
  return load;
}

Vector3 mean_displacement(const Discretisation& body, const std::string& region,
                          const Eigen::VectorXd& displacements) {
  Vector3 integral = Vector3::Zero();
  double whole = 0;
  for (const auto& [node, area] : body.regions.at(region)) {
    integral += area * displacements.segment<3>(3 * node);
    whole += area;
  }
  return integral / whole;
}

}  // namespace springcheck::fem_reference
