#include "fem_reference/explicit/plain_forces.hpp"

#include "fem_reference/explicit/hexahedra.hpp"

namespace springcheck::fem_reference {
namespace {

Eigen::Matrix3d green_strain(const Eigen::Matrix3d& h) {
  return (h + h.transpose() + h.transpose() * h) / 2;
}

/// Calls law(V, B) for each point of the element, then for one_point
/// hourglass(k_s, gamma_s) for each mode.
template <class AtPoint, class OfMode>
void for_each_point(ExplicitElement element, const CornerVectors& rest,
                    const AtPoint& at_point, const OfMode& of_mode) {
  if (element == ExplicitElement::eight_points) {
    const std::array<GaussPoint, 8> points = gauss_points(rest);
    for (std::size_t p = 0; p < 8; ++p)
      at_point(points[p].volume, shape_gradients(points[p], p));
    return;
  }
  const OnePointCell cell = one_point_cell(rest);
  at_point(cell.volume, cell.gradients);
  for (Eigen::Index h = 0; h < 4; ++h)
    of_mode(cell.hourglass_stiffness[h],
            Eigen::Matrix<double, 8, 1>(cell.hourglass_shapes.row(h).transpose()));
}

CornerVectors cell_forces(const CornerVectors& rest, const LameConstants& lame,
                          ExplicitElement element, const CornerVectors& u) {
  CornerVectors forces = CornerVectors::Zero();
  for_each_point(
      element, rest,
      [&](double volume, const CornerVectors& gradients) {
        const Eigen::Matrix3d h = u * gradients.transpose();
        const Eigen::Matrix3d strain = green_strain(h);
        const Eigen::Matrix3d stress =
            lame.lambda * strain.trace() * Eigen::Matrix3d::Identity() +
            2 * lame.mu * strain;
        forces -= volume * (Eigen::Matrix3d::Identity() + h) * stress * gradients;
      },
      [&](double stiffness, const Eigen::Matrix<double, 8, 1>& gamma) {
        forces -= lame.mu * stiffness * (u * gamma) * gamma.transpose();
      });
  return forces;
}

double cell_energy(const CornerVectors& rest, const LameConstants& lame,
                   ExplicitElement element, const CornerVectors& u) {
  double energy = 0;
  for_each_point(
      element, rest,
      [&](double volume, const CornerVectors& gradients) {
        const Eigen::Matrix3d strain = green_strain(u * gradients.transpose());
        energy += volume * (lame.lambda / 2 * strain.trace() * strain.trace() +
                            lame.mu * strain.squaredNorm());
      },
      [&](double stiffness, const Eigen::Matrix<double, 8, 1>& gamma) {
        energy += lame.mu / 2 * stiffness * (u * gamma).squaredNorm();
      });
  return energy;
}

}  // namespace

std::vector<Vector3> plain_forces(const Mesh& mesh, const LameConstants& lame,
                                  ExplicitElement element,
                                  std::span<const Vector3> displacements) {
  std::vector<Vector3> forces(mesh.nodes().size(), Vector3::Zero());
  for (const CellNodes& cell : mesh.cells()) {
    const CornerVectors f = cell_forces(corner_vectors(cell, mesh.nodes()), lame, element,
                                        corner_vectors(cell, displacements));
    for (std::size_t c = 0; c < 8; ++c)
      forces[cell[grid_corners[c]]] += f.col(static_cast<Eigen::Index>(c));
  }
  return forces;
}

double plain_energy(const Mesh& mesh, const LameConstants& lame, ExplicitElement element,
                    std::span<const Vector3> displacements) {
  double energy = 0;
  for (const CellNodes& cell : mesh.cells())
    energy += cell_energy(corner_vectors(cell, mesh.nodes()), lame, element,
                          corner_vectors(cell, displacements));
  return energy;
}

std::vector<double> lumped_masses(const Mesh& mesh, double density) {
  std::vector<double> masses(mesh.nodes().size(), 0);
  for (const CellNodes& cell : mesh.cells()) {
    const auto volumes = corner_volumes(corner_vectors(cell, mesh.nodes()));
    for (std::size_t c = 0; c < 8; ++c)
      masses[cell[grid_corners[c]]] += density * volumes[c];
  }
  return masses;
}

}  // namespace springcheck::fem_reference
