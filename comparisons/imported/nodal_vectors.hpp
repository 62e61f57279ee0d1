#pragma once

#include <string>
#include <vector>

#include "meshing/point_tree.hpp"

namespace springcheck {

/// Distance from a node within which a point is that node [m]: 1e-6 of the mesh's
/// shortest edge.
double node_tolerance(const Mesh& mesh);

/// One vector for each node of a mesh, which must outlive it, collected from a file in
/// any order. Every `place` ("mine.csv:7", "mine.vtu: point 3") is for messages. Throws
/// InputError for a vector that is not finite and for a node that has one already.
class NodalVectors {
 public:
  /// kind: "displacement", for messages.
  NodalVectors(const Mesh& mesh, std::string kind);

  void add(const std::string& place, NodeIndex node, const Vector3& value);

  /// The node is the one at this point, whose coordinates were rounded by so much [m];
  /// InputError where none is.
  void add_at(const std::string& place, const Vector3& point, double rounding,
              const Vector3& value);

  /// All of them. Throws InputError, naming the file, where a node has none.
  [[nodiscard]] std::vector<Vector3> complete(const std::string& file) const;

  /// All of them, zero where a node has none.
  [[nodiscard]] const std::vector<Vector3>& or_zero() const { return values_; }

 private:
  const Mesh& mesh_;
  PointTree nodes_;
  double tolerance_;
  std::string kind_;
  std::vector<Vector3> values_;
  std::vector<std::string> places_;  // of the values; empty without one
};

}  // namespace springcheck
