#include "meshing/loads/traction.hpp"

#include <cmath>

namespace springcheck {
namespace {

/// Signs of a face's corners in its coordinates xi, eta in [-1, 1].
constexpr std::array<std::array<double, 2>, 4> corner_signs{
    {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

}  // namespace

std::vector<double> nodal_areas(const Mesh& mesh, const Region& region) {
  std::vector<double> areas(mesh.nodes().size(), 0);
  const double gauss = 1 / std::sqrt(3.);
  for (const FaceNodes& face : region.faces) {
    if (face.size() == 3) {
      const Vector3 &a = mesh.nodes()[face[0]], &b = mesh.nodes()[face[1]],
                    &c = mesh.nodes()[face[2]];
      for (const NodeIndex node : face) areas[node] += (b - a).cross(c - a).norm() / 6;
      continue;
    }
    for (const auto& [xi_sign, eta_sign] : corner_signs) {
      const double xi = gauss * xi_sign, eta = gauss * eta_sign;
      std::array<double, 4> shape{};
      Vector3 along_xi = Vector3::Zero(), along_eta = Vector3::Zero();
      for (std::size_t a = 0; a < 4; ++a) {
        const auto [s, t] = corner_signs[a];
        const Vector3& x = mesh.nodes()[face[a]];
        shape[a] = (1 + s * xi) * (1 + t * eta) / 4;
        along_xi += s * (1 + t * eta) / 4 * x;
        along_eta += t * (1 + s * xi) / 4 * x;
      }
      const double area = along_xi.cross(along_eta).norm();  // the point's weight is 1
      for (std::size_t a = 0; a < 4; ++a) areas[face[a]] += shape[a] * area;
    }
  }
  return areas;
}

std::vector<Vector3> traction_forces(const Mesh& mesh, const Scene& scene) {
  std::vector<Vector3> forces(mesh.nodes().size(), Vector3::Zero());
  for (const auto& [region, stress] : scene.tractions) {
    const std::vector<double> areas = nodal_areas(mesh, mesh.region(region));
    for (std::size_t n = 0; n < forces.size(); ++n) forces[n] += areas[n] * stress;
  }
  return forces;
}

std::vector<Vector3> load_forces(const Mesh& mesh, const Scene& scene,
                                 std::span<const double> masses) {
  std::vector<Vector3> forces = traction_forces(mesh, scene);
  for (std::size_t n = 0; n < forces.size(); ++n) forces[n] += masses[n] * scene.gravity;
  return forces;
}

}  // namespace springcheck
