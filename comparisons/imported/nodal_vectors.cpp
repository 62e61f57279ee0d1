#include "comparisons/imported/nodal_vectors.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

std::string text_of(const Vector3& v) {
  return fmt::format("({:g}, {:g}, {:g})", v.x(), v.y(), v.z());
}

}  // namespace

NodalVectors::NodalVectors(const Mesh& mesh, std::string kind)
    : mesh_(mesh),
      finder_(mesh),
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
  const auto node = finder_.at(point, rounding);
  if (!node) {
    const NodeIndex nearest = finder_.nearest(point);
    const Vector3& there = mesh_.nodes()[nearest];
    throw InputError(
        place, "point " + text_of(point),
        fmt::format("a node of the mesh, within {:.2g} m", finder_.tolerance()),
        fmt::format("one that is {:.3g} m from the nearest, node {} at {}",
                    (there - point).norm(), nearest + 1, text_of(there)));
  }
  add(place, *node, value);
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
