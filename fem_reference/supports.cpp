#include "fem_reference/supports.hpp"

#include <algorithm>
#include <set>

namespace springcheck::fem_reference {
namespace {

using Entities = std::set<std::vector<NodeIndex>>;

/// Edges and faces of a region, as their ascending vertices.
void add_entities(Entities& entities, const Region& region) {
  for (const Quadrilateral& face : region.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto [a, b] = std::minmax(face[i], face[(i + 1) % face.size()]);
      entities.insert({a, b});
    }
    std::vector<NodeIndex> whole(face.begin(), face.end());
    std::ranges::sort(whole);
    entities.insert(std::move(whole));
  }
}

}  // namespace

Supports::Supports(const Mesh& mesh, const Scene& scene, const Discretisation& body)
    : mesh_(mesh),
      scene_(scene),
      at_vertices_(prescribed_components(mesh, scene)),
      prescribed_(3 * body.nodes.size(), false) {
  for (const auto& [node, component, plate] : at_vertices_)
    prescribed_[3 * node + component] = true;
  if (body.parents.empty()) return;
  std::vector<bool> by_plate(prescribed_.size(), false);  // or boundary, but not a pin
  for (const auto& [node, component, plate] : at_vertices_)
    by_plate[3 * node + component] = plate || scene.boundary_gradient;
  Entities held;
  for (const Plate& plate : scene.plates) add_entities(held, mesh.region(plate.region));
  if (scene.boundary_gradient) add_entities(held, mesh.boundary());
  for (std::size_t i = 0; i < body.parents.size(); ++i) {
    const auto node = static_cast<NodeIndex>(body.vertices + i);
    const std::vector<NodeIndex>& parents = body.parents[i];
    if (!held.contains(parents)) continue;
    intermediate_.push_back({.node = node, .parents = parents});
    for (std::size_t component = 0; component < 3; ++component)
      prescribed_[3 * node + component] = std::ranges::all_of(
          parents, [&](NodeIndex parent) { return by_plate[3 * parent + component]; });
  }
}

Eigen::VectorXd Supports::displacements(double load_fraction) const {
  Eigen::VectorXd nodal =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(prescribed_.size()));
  for (const PrescribedComponent& at : at_vertices_)
    nodal[3 * at.node + at.component] =
        prescribed_displacement(mesh_, scene_, at, load_fraction);
  for (const auto& [node, parents] : intermediate_)
    for (std::size_t i = 0; i < 3; ++i)
      if (prescribed_[3 * node + i])
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
