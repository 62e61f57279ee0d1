#pragma once

#include <functional>
#include <optional>

#include "meshing/loads/scene.hpp"

namespace springcheck {

/// Volume-weighted root mean square, and largest, of a distance over the nodes with a
/// free component; none without such nodes.
struct FreeDistance {
  double root_mean_square;
  double largest;
};
std::optional<FreeDistance> over_free_nodes(
    const Mesh& mesh, const Scene& scene,
    const std::function<double(std::size_t)>& distance);

/// Largest displacement that the plates or the boundary gradient impose on a node on the
/// way to the scene's load [m]. A plate that turns moves its nodes farthest in half a
/// turn; one that turns and moves along is looked at there and at the end only.
double largest_imposed_displacement(const Mesh& mesh, const Scene& scene);

/// Mean displacement of the face that the scene's traction loads [m], int u dA/A over its
/// undeformed area: the solution's own, or that of a u bilinear on each face of a cell.
Vector3 loaded_face_displacement(const Mesh& mesh, const Scene& scene,
                                 const Solution& solution);

}  // namespace springcheck
