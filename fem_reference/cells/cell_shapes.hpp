#pragma once

#include <deal.II/grid/tria.h>

#include <memory>
#include <vector>

#include "fem_reference/cells/cell.hpp"
#include "meshing/mesh.hpp"

namespace springcheck::fem_reference {

/// The element's shape on each cell, at the Gauss points of its type:
///
///     tetrahedron  1, linear shape functions: their gradients are constant
///     pyramid      2 x 2 x 2, in (x, y)/(1 - z) bilinear ones times 1 - z, and z
///     prism        3 x 2, linear in the triangle by linear along z
///     hexahedron   2 x 2 x 2, trilinear; 3 x 3 x 3 for q2
///
/// They integrate the volume exactly for any positions of the nodes, quadrilaterals being
/// bilinear: det J is of second degree in each coordinate of a hexahedron, in a pyramid's
/// x/(1 - z) and y/(1 - z) (its points know the weight (1 - z)^2), and along a prism,
/// where it is linear in the triangle. Hence sum w grad N_a = dV/dX_a exactly, these
/// cancel where cells meet, and the patch test is passed whatever the cells' shape.
/// Source of the pyramid: Bedrosian, Int. J. Numer. Methods Eng. 35 (1992) 95.
///
/// Cells that are translations of a recent one share its shape. The triangulation is the
/// mesh's; only hexahedra have q2.
std::vector<std::shared_ptr<const Shape>> cell_shapes(
    const Mesh& mesh, const dealii::Triangulation<3>& triangulation, Element element);

}  // namespace springcheck::fem_reference
