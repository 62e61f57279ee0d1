#include "fem_reference/statics/supports.hpp"

#include <algorithm>
#include <map>

namespace springcheck::fem_reference {
namespace {

/// Components in which plates hold their edges and faces, by the ascending vertices of
/// these.
using HeldEntities = std::map<std::vector<NodeIndex>, Held>;

void hold(HeldEntities& entities, const Region& region, const Held& held) {
  const auto hold_one = [&](std::vector<NodeIndex> vertices) {
    std::ranges::sort(vertices);
    Held& entity = entities[std::move(vertices)];
    for (std::size_t i = 0; i < 3; ++i) entity[i] = entity[i] || held[i];
  };
  for (const FaceNodes& face : region.faces) {
    for (std::size_t i = 0; i < face.size(); ++i)
      hold_one({face[i], face[(i + 1) % face.size()]});
    hold_one({face.begin(), face.end()});
  }
}

}  // namespace

Supports::Supports(const Mesh& mesh, const Scene& scene, const Discretisation& body)
    : mesh_(mesh),
      scene_(scene),
      at_vertices_(prescribed_components(mesh, scene)),
      is_free_(3 * body.nodes.size(), true) {
  for (const auto& [node, component, plate] : at_vertices_)
    is_free_[3 * node + component] = false;
  if (body.parents.empty()) return;
  HeldEntities held;
  for (const Plate& plate : scene.plates)
    hold(held, mesh.region(plate.region), plate.held);
  if (scene.boundary_gradient) hold(held, mesh.boundary(), all_components);
  for (std::size_t i = 0; i < body.parents.size(); ++i) {
    const auto found = held.find(body.parents[i]);
    if (found == held.end()) continue;
    const auto node = static_cast<NodeIndex>(body.vertices + i);
    intermediate_.push_back({.node = node, .parents = body.parents[i]});
    for (std::size_t component = 0; component < 3; ++component)
      is_free_[3 * node + component] = !found->second[component];
  }
}

Eigen::VectorXd Supports::displacements(double load_fraction) const {
  Eigen::VectorXd nodal =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(is_free_.size()));
  for (const PrescribedComponent& at : at_vertices_)
    nodal[3 * at.node + at.component] =
        prescribed_displacement(mesh_, scene_, at, load_fraction);
  for (const auto& [node, parents] : intermediate_)
    for (std::size_t i = 0; i < 3; ++i)
      if (!is_free_[3 * node + i])
        for (const NodeIndex parent : parents)
          nodal[static_cast<Eigen::Index>(3 * node + i)] +=
              nodal[static_cast<Eigen::Index>(3 * parent + i)] /
              static_cast<double>(parents.size());
  return nodal;
}

std::vector<Vector3> on_vertices(const Discretisation& body,
                                 const Eigen::VectorXd& nodal_forces) {
  std::vector<Vector3> forces;
  for (std::size_t node = 0; node < body.vertices; ++node)
    forces.emplace_back(nodal_forces.segment<3>(static_cast<Eigen::Index>(3 * node)));
  for (std::size_t i = 0; i < body.parents.size(); ++i) {
    const Vector3 share =
        nodal_forces.segment<3>(static_cast<Eigen::Index>(3 * (body.vertices + i))) /
        static_cast<double>(body.parents[i].size());
    for (const NodeIndex parent : body.parents[i]) forces[parent] += share;
  }
  return forces;
}

}  // namespace springcheck::fem_reference
