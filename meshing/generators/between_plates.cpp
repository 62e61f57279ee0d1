#include "meshing/generators/between_plates.hpp"

#include <algorithm>
#include <cmath>

#include "meshing/generators/z_curve.hpp"

namespace springcheck {
namespace {

/// The boundary's faces on the two plates, and the rest.
std::map<std::string, std::vector<FaceNodes>> regions_of(const Mesh& mesh,
                                                         double height) {
  std::map<std::string, std::vector<FaceNodes>> regions;
  for (const FaceNodes& face : mesh.boundary().faces) {
    const auto is_at = [&](double z) {
      return std::ranges::all_of(
          face, [&](NodeIndex node) { return mesh.nodes()[node].z() == z; });
    };
    regions[is_at(0) ? "bottom" : is_at(height) ? "top" : "surface"].push_back(face);
  }
  return regions;
}

}  // namespace

Mesh mesh_between_plates(const std::string& source, const MeshParts& parts, double unit,
                         double height) {
  MeshParts ordered = along_z_curve(parts);
  for (Vector3& x : ordered.nodes) {
    x *= unit;
    for (const double plate : {0., height})
      if (std::abs(x.z() - plate) < 1e-6 * height) x.z() = plate;
  }
  const Mesh mesh(source, std::move(ordered.nodes), std::move(ordered.cells), {});
  return {mesh.source(), mesh.nodes(), mesh.cells(), regions_of(mesh, height)};
}

}  // namespace springcheck
