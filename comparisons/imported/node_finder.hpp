#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck {

/// Length of the shortest edge of all cells [m].
double smallest_edge(const Mesh& mesh);

/// Finds the nodes of a mesh, which must outlive it, by their coordinates.
class NodeFinder {
 public:
  explicit NodeFinder(const Mesh& mesh);

  /// Distance within which a point is a node [m]: 1e-6 of the smallest edge.
  [[nodiscard]] double tolerance() const { return 1e-6 * edge_; }

  /// The node at the point, to the tolerance and what the point's coordinates were
  /// rounded by [m]; none where no node is.
  [[nodiscard]] std::optional<NodeIndex> at(const Vector3& point,
                                            double rounding = 0) const;

  /// The node nearest to the point, however far. Looks at all.
  [[nodiscard]] NodeIndex nearest(const Vector3& point) const;

 private:
  using Bin = std::array<double, 3>;  // whole numbers of edges; doubles cannot overflow
  [[nodiscard]] Bin bin_of(const Vector3& point) const;

  const Mesh& mesh_;
  double edge_;
  std::map<Bin, std::vector<NodeIndex>> bins_;
};

}  // namespace springcheck
