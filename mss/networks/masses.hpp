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

/// Volume as the sum of the tetrahedra that the cell is cut into [m^3]: a prism into 3, a
/// pyramid into 2, a hexahedron into two prisms. Exact where the faces are plane; of a
/// warped face it sees one diagonal, the neighbour perhaps the other, and the volumes of
/// cells that fill a body do not add up to the body's.
/// Source: Golec 2018, Eq. 6.3 to 6.6 and section 6.1, whose P1 to P6 of a prism are our
/// 0, 1, 2, 4, 3, 5.
double volume_of_tetrahedra(const CornerPositions& x);

}  // namespace springcheck::mss
