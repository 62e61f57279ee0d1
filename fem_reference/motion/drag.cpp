#include "fem_reference/motion/drag.hpp"

#include <cmath>
#include <numbers>

namespace springcheck::fem_reference {
namespace {

double longest_extent(const Mesh& mesh) {
  Vector3 low = mesh.nodes().front(), high = low;
  for (const Vector3& x : mesh.nodes()) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).maxCoeff();
}

}  // namespace

double drag_rate(const Mesh& mesh, const Material& material, double damping_ratio) {
  const double shear_speed = std::sqrt(lame_constants(material).mu / material.density);
  return 2 * damping_ratio * std::numbers::pi * shear_speed / longest_extent(mesh);
}

std::vector<Vector3> with_drag(std::vector<Vector3> forces, double rate,
                               std::span<const double> masses,
                               std::span<const Vector3> velocities) {
  if (rate > 0)
    for (std::size_t n = 0; n < forces.size(); ++n)
      forces[n] -= rate * masses[n] * velocities[n];
  return forces;
}

}  // namespace springcheck::fem_reference
