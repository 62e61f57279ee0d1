#pragma once

#include <functional>
#include <string>

#include "meshing/mesh.hpp"

namespace springcheck {

/// How errors call a node.
using NodeName = std::function<std::string(NodeIndex)>;

/// Throws InputError unless cells that touch share their nodes and faces. Refused are, on
/// the boundary,
///
///     two nodes in one place: parts that were never merged, or a crack
///     a node inside a face, or an edge, of which it is no corner: it hangs
///     an edge across a quadrilateral of which it is a diagonal: triangles against it
///     four triangles around a tetrahedron that is no cell: two pairs of them, cut along
///     different diagonals
///
/// "In" a place is within 1e-5 of the face's longest edge from it, for two nodes of the
/// shorter of the shortest edges at them. Takes time in proportion to the number of cells
/// (times a logarithm).
void check_conformity(const Mesh& mesh, const NodeName& name);

/// The same, "node 5" for number 5.
void check_conformity(const Mesh& mesh);

}  // namespace springcheck
