#pragma once

#include "meshing/generators/block.hpp"
#include "meshing/mesh_parts.hpp"

namespace springcheck {

/// The block as three zones of the grid's layers along z, of which it has three at least:
/// hexahedra below, a layer cut around the centres into a pyramid on each of them and
/// tetrahedra elsewhere, and above, in half of the layers' height, gmsh's tetrahedra.
///
/// The pyramids are our own because those that gmsh 4.8.4 puts between hexahedra and
/// tetrahedra overlap in one block of three, and it reads memory out of bounds.
MeshParts transition_block(const Block& block);

}  // namespace springcheck
