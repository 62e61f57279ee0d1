#pragma once

#include <vector>

#include "meshing/cell_geometry.hpp"

namespace springcheck::mss {

/// How a cell's volume is distributed to its nodes:
///
///     V_a = (V/n) [1 + (c - xm) . S^-1 (X_a - xm)]
///
/// with its centroid c, the mean xm of its n nodes and S the mean of (X_a - xm) (x)
/// (X_a - xm): V and the centre of mass are exact. Equal shares for tetrahedra and
/// parallelepipeds, where c = xm. A cell so misshapen that a share would not be positive
/// gets equal ones: dynamics needs masses, and only its own centre of mass is off then.
/// [m^3]; times the density, the nodes' masses.
/// Source: own; of all shares linear in X_a, those with the cell's volume and centroid.
std::vector<double> nodal_volumes(const CornerPositions& x);

/// A node's part of the cell's volume in the thesis, V/n, of which a pyramid's centre of
/// mass is h/20 too high. Times the density, the mass m_v.
/// Source: Golec 2018, Eq. 6.1.
double equal_nodal_volume(const CornerPositions& x);

}  // namespace springcheck::mss
