#include "comparisons/imported/nodal_vectors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

std::string text_of(const Vector3& v) {
  return fmt::format("({:g}, {:g}, {:g})", v.x(), v.y(), v.z());
}

std::vector<NodeIndex> all_nodes(const Mesh& mesh) {
  std::vector<NodeIndex> nodes(mesh.nodes().size());
  std::iota(nodes.begin(), nodes.end(), NodeIndex{0});
  return nodes;
}

}  // namespace

double node_tolerance(const Mesh& mesh) {
  double shortest = INFINITY;
  for (const CellNodes& cell : mesh.cells())
    for (const auto& [a, b] : edges(type_of(cell)))
      shortest =
          std::min(shortest, (mesh.nodes()[cell[b]] - mesh.nodes()[cell[a]]).norm());
  return 1e-6 * shortest;
}

NodalVectors::NodalVectors(const Mesh& mesh, std::string kind)
    : mesh_(mesh),
      nodes_(mesh.nodes(), all_nodes(mesh)),
      tolerance_(node_tolerance(mesh)),
      kind_(std::move(kind)),
      values_(mesh.nodes().size(), Vector3::Zero()),
      places_(mesh.nodes().size()) {}

void NodalVectors::add(const std::string& place, NodeIndex node, const Vector3& value) {
  const std::string entity = fmt::format("{} of node {}", kind_, node + 1);
  if (!value.allFinite())
    throw InputError(place, entity, "finite numbers", text_of(value));
  if (!places_[node].empty())
    throw InputError(place, entity, "one only", "another one after " + places_[node]);
  places_[node] = place;
  values_[node] = value;
}

void NodalVectors::add_at(const std::string& place, const Vector3& point, double rounding,
                          const Vector3& value) {
  if (!point.allFinite())
    throw InputError(place, "point", "finite coordinates", text_of(point));
  const NodeIndex nearest = nodes_.nearest(point);
  const Vector3& there = mesh_.nodes()[nearest];
  if (const double distance = (there - point).norm(); distance > tolerance_ + rounding)
    throw InputError(place, "point " + text_of(point),
                     fmt::format("a node of the mesh, within {:.2g} m", tolerance_),
                     fmt::format("one that is {:.3g} m from the nearest, node {} at {}",
                                 distance, nearest + 1, text_of(there)));
  add(place, nearest, value);
}

std::vector<Vector3> NodalVectors::complete(const std::string& file) const {
  const auto missing = std::ranges::count(places_, std::string());
  if (missing > 0) {
    const auto first = std::ranges::find(places_, std::string()) - places_.begin();
    throw InputError(
        file, "",
        fmt::format("a {} of each of the mesh's {} nodes", kind_, mesh_.nodes().size()),
        fmt::format("none of {} of them, the first is node {} at {}", missing, first + 1,
                    text_of(mesh_.nodes()[static_cast<NodeIndex>(first)])));
  }
  return values_;
}

}  // namespace springcheck
