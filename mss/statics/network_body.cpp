#include "mss/statics/network_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshing/loads/traction.hpp"
#include "mss/forces/forces.hpp"
#include "statics/systems/nodal_vectors.hpp"

namespace springcheck::mss {

NetworkBody::NetworkBody(const Network& network)
    : network_(network), tangent_{.network = &network, .positions = {}, .states = {}} {}

std::span<const Vector3> NetworkBody::nodes() const {
  return network_.rest_positions;
}

double NetworkBody::cell_edge() const {
  double volume = 0;
  for (std::size_t c = 0; c < network_.cells.size(); ++c)
    volume += network_.cells.volume(c);
  return std::cbrt(volume / static_cast<double>(network_.cells.size()));
}

std::vector<Vector3> NetworkBody::positions(const Eigen::VectorXd& displacements) const {
  return statics::by_node(statics::stacked(nodes()) + displacements);
}

statics::ElasticBody::State NetworkBody::state(const Eigen::VectorXd& displacements) {
  const std::vector<Vector3> x = positions(displacements);
  std::vector<Vector3> forces(x.size());
  nodal_forces(network_, x, states_, forces);
  return {.strain_energy = strain_energy(network_, x),
          .forces = statics::stacked(forces)};
}

statics::Patches NetworkBody::patches() const {
  return mss::patches(network_);
}

void NetworkBody::linearise(const Eigen::VectorXd& displacements) {
  tangent_ = tangent_at(network_, positions(displacements));
}

Eigen::MatrixXd NetworkBody::part(std::size_t patch) const {
  return mss::part(tangent_, patch);
}

Eigen::MatrixXd NetworkBody::positive_part(std::size_t patch) const {
  return mss::positive_part(tangent_, patch);
}

double NetworkBody::mean_gradient(const Eigen::VectorXd& field) const {
  double sum = 0;
  std::size_t count = 0;
  for_each_dashpot(network_, [&](const Spring& spring) {
    const Vector3 change = field.segment<3>(3 * Eigen::Index{spring.b}) -
                           field.segment<3>(3 * Eigen::Index{spring.a});
    sum += change.squaredNorm() / (spring.rest_length * spring.rest_length);
    ++count;
  });
  return std::sqrt(sum / static_cast<double>(count));
}

double NetworkBody::largest_volume_ratio(const Eigen::VectorXd& displacements) const {
  const std::vector<Vector3> u = statics::by_node(displacements);
  double largest = 0;
  for (std::size_t c = 0; c < network_.cells.size(); ++c)
    largest =
        std::max(largest, 1 + volume_change(network_.cells.displacement_gradient(c, u)));
  return largest;
}

double NetworkBody::rounding(const Eigen::VectorXd& displacements) const {
  return std::numeric_limits<double>::epsilon() *
         (statics::stacked(nodes()) + displacements).cwiseAbs().maxCoeff();
}

statics::Loading loading(const Mesh& mesh, const Scene& scene, const Network& network) {
  return statics::loading(mesh, scene,
                          statics::stacked(load_forces(mesh, scene, network.masses)));
}

}  // namespace springcheck::mss
