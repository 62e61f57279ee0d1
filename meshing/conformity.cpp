#include "meshing/conformity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "meshing/basics/input_error.hpp"
#include "meshing/on_face.hpp"
#include "meshing/point_tree.hpp"

namespace springcheck {
namespace {

constexpr double nearness = 1e-5;  // of an edge: what two places in one file may be apart

using Edge = std::array<NodeIndex, 2>;  // ascending

std::string names_of(const FaceNodes& nodes, const NodeName& name) {
  std::vector<std::string> names;
  for (const NodeIndex node : nodes) names.push_back(name(node));
  return fmt::format("{}", fmt::join(names, ", "));
}

Edge edge_between(NodeIndex a, NodeIndex b) {
  return {std::min(a, b), std::max(a, b)};
}

std::vector<Edge> edges_of(const std::vector<FaceNodes>& faces) {
  std::vector<Edge> edges;
  for (const FaceNodes& face : faces)
    for (std::size_t i = 0; i < face.size(); ++i)
      edges.push_back(edge_between(face[i], face[(i + 1) % face.size()]));
  std::ranges::sort(edges);
  const auto repeated = std::ranges::unique(edges);
  edges.erase(repeated.begin(), repeated.end());
  return edges;
}

Eigen::AlignedBox3d grown(const Eigen::AlignedBox3d& box, double by) {
  return {box.min() - Vector3::Constant(by), box.max() + Vector3::Constant(by)};
}

void check_places(const Mesh& mesh, const PointTree& tree, const std::vector<Edge>& edges,
                  const NodeName& name) {
  std::vector<double> shortest(mesh.nodes().size(),
                               std::numeric_limits<double>::infinity());
  for (const Edge& edge : edges) {
    const double length = (mesh.nodes()[edge[0]] - mesh.nodes()[edge[1]]).norm();
    for (const NodeIndex node : edge) shortest[node] = std::min(shortest[node], length);
  }
  for (const NodeIndex node : mesh.boundary().nodes) {
    const Vector3& x = mesh.nodes()[node];
    for (const NodeIndex other :
         tree.in_box(grown(Eigen::AlignedBox3d(x), nearness * shortest[node])))
      if (other != node && (mesh.nodes()[other] - x).norm() <=
                               nearness * std::min(shortest[node], shortest[other]))
        throw InputError(mesh.source(), name(std::min(node, other)),
                         "a place of its own, or cells merged there",
                         name(std::max(node, other)) + " in the same place");
  }
}

void check_hanging(const Mesh& mesh, const PointTree& tree, const NodeName& name) {
  for (const FaceNodes& face : mesh.boundary().faces) {
    Eigen::AlignedBox3d box;
    double longest = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vector3 &x = mesh.nodes()[face[i]],
                    &next = mesh.nodes()[face[(i + 1) % face.size()]];
      box.extend(x);
      longest = std::max(longest, (next - x).norm());
    }
    for (const NodeIndex node : tree.in_box(grown(box, nearness * longest)))
      if (std::ranges::count(face, node) == 0 &&
          is_on_face(mesh.nodes()[node], face, mesh.nodes(), nearness * longest))
        throw InputError(mesh.source(), name(node),
                         "a corner of every face that it lies in",
                         "it inside the face of " + names_of(face, name));
  }
}

void check_quadrilaterals(const Mesh& mesh, const std::vector<Edge>& edges,
                          const NodeName& name) {
  for (const FaceNodes& face : mesh.boundary().faces) {
    if (face.size() != 4) continue;
    for (const std::size_t i : {0U, 1U})
      if (std::ranges::binary_search(edges, edge_between(face[i], face[i + 2])))
        throw InputError(mesh.source(), "quadrilateral of " + names_of(face, name),
                         "a quadrilateral against it",
                         fmt::format("triangles with an edge from {} to {}",
                                     name(face[i]), name(face[i + 2])));
  }
}

/// Node sets, ascending, of tetrahedra whose four faces are all in the sorted triangles.
std::vector<FaceNodes> enclosed_tetrahedra(const std::vector<FaceNodes>& triangles) {
  struct Opposite {
    Edge edge;
    NodeIndex node;
  };
  std::vector<Opposite> opposites;
  for (const FaceNodes& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      opposites.push_back(
          {.edge = edge_between(t[i], t[(i + 1) % 3]), .node = t[(i + 2) % 3]});
  std::ranges::stable_sort(opposites, {}, &Opposite::edge);
  const auto is_triangle = [&](NodeIndex a, NodeIndex b, NodeIndex c) {
    return std::ranges::binary_search(triangles, ascending({a, b, c}));
  };
  std::vector<FaceNodes> found;
  for (auto first = opposites.begin(); first != opposites.end(); ++first)
    for (auto second = first + 1;
         second != opposites.end() && second->edge == first->edge; ++second)
      if (is_triangle(first->edge[0], first->node, second->node) &&
          is_triangle(first->edge[1], first->node, second->node))
        found.push_back(
            ascending({first->edge[0], first->edge[1], first->node, second->node}));
  std::ranges::sort(found);
  return found;
}

void check_voids(const Mesh& mesh, const NodeName& name) {
  std::vector<FaceNodes> triangles, cells;
  for (const FaceNodes& face : mesh.boundary().faces)
    if (face.size() == 3) triangles.push_back(ascending(face));
  std::ranges::sort(triangles);
  for (const CellNodes& cell : mesh.cells())
    if (cell.size() == 4) cells.push_back(ascending(FaceNodes(cell)));
  std::ranges::sort(cells);
  for (const FaceNodes& nodes : enclosed_tetrahedra(triangles))
    if (!std::ranges::binary_search(cells, nodes))
      throw InputError(mesh.source(), "triangles of " + names_of(nodes, name),
                       "two cut along the same diagonal",
                       "two pairs cut along different ones");
}

}  // namespace

void check_conformity(const Mesh& mesh, const NodeName& name) {
  const PointTree tree(mesh.nodes(), mesh.boundary().nodes);
  const std::vector<Edge> edges = edges_of(mesh.boundary().faces);
  check_places(mesh, tree, edges, name);
  check_hanging(mesh, tree, name);
  check_quadrilaterals(mesh, edges, name);
  check_voids(mesh, name);
}

void check_conformity(const Mesh& mesh) {
  check_conformity(mesh, [](NodeIndex node) { return fmt::format("node {}", node + 1); });
}

}  // namespace springcheck
