#pragma once

#include <array>

#include "meshing/loads/scene.hpp"
#include "statics/systems/natural_modes.hpp"

namespace springcheck {

/// The lowest `count` elastic modes of a free block [0, L_x] x [0, L_y] x [0, L_z] of
/// Hooke's material, by Rayleigh and Ritz: the stationary values of
///
///     omega^2 = int (lambda (div u)^2 + 2 mu eps:eps) dV / int rho u.u dV
///
/// among displacements whose components are polynomials up to a total `degree`. No mesh
/// and no solver shared with the finite elements. Frequencies are upper bounds, which for
/// a cube's first ten modes are within 1e-4 of the limit at degree 10. Shapes are sampled
/// at the points, rows 3 point + component.
///
/// Exact among a cube's modes of edge L are Lame's three, without change of volume:
///
///     f = sqrt(mu/rho)/(sqrt(2) L)
///
/// Source: Demarest, J. Acoust. Soc. Am. 49 (1971) 768, with orthonormal Legendre
/// polynomials; of Lame's modes Graff, Wave Motion in Elastic Solids (1975), section 8.1.
NaturalModes free_block_modes(const std::array<double, 3>& size, const Material& material,
                              int degree, int count, const std::vector<Vector3>& points);

}  // namespace springcheck
