#pragma once

#include <span>
#include <vector>

#include "fem_reference/explicit/explicit_element.hpp"
#include "meshing/loads/scene.hpp"

namespace springcheck::fem_reference {

/// Internal forces of St-Venant-Kirchhoff's law on a mesh of hexahedra [N], one per node,
/// by plain loops in double precision: what the kernels are checked against. At each
/// point, of volume V and shape gradients B_a, with H = sum u_a (x) B_a,
///
///     E = (H + H^T + H^T H)/2,   S = lambda tr(E) I + 2 mu E,   f_a -= V (I + H) S B_a
///
/// and for one_point the hourglass control (hexahedra.hpp), f_a -= mu sum_s k_s gamma_sa
/// q_s.
/// Source: the derivative of the energy below by u_a; st_venant_kirchhoff.hpp.
std::vector<Vector3> plain_forces(const Mesh& mesh, const LameConstants& lame,
                                  ExplicitElement element,
                                  std::span<const Vector3> displacements);

/// sum V (lambda/2 (tr E)^2 + mu E:E), and of one_point mu/2 sum_s k_s |q_s|^2 [J].
double plain_energy(const Mesh& mesh, const LameConstants& lame, ExplicitElement element,
                    std::span<const Vector3> displacements);

/// Lumped masses [kg]: the row sums of the consistent mass matrix, see corner_volumes.
std::vector<double> lumped_masses(const Mesh& mesh, double density);

}  // namespace springcheck::fem_reference
