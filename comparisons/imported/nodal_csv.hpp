#pragma once

#include <filesystem>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck {

/// What a CSV file holds of the nodes: its columns, and what a node left out means.
///
///     displacement   ux,uy,uz [m]   every node must have one
///     force          fx,fy,fz [N]   a node left out has none
enum class NodalQuantity { displacement, force };

/// One vector for each node from a CSV file: a line that names the columns, in any order,
/// then a row for each node, in any order. Beside the three components,
///
///     x,y,z   the node's undeformed coordinates [m], to 1e-6 of the smallest edge; or
///     node    (id, node id, node number) its number, from 1, as in the .msh and .inp
///             files that write_mesh makes; not read beside coordinates
///
/// Names may have capitals, quotes and a unit ("UX [m]"). Columns are parted by
/// semicolons, commas, tabs or blanks, the first of these that the line of names has;
/// decimals may have a comma where columns have none between. Further columns, blank
/// lines, carriage returns and lines that begin with '#' or '%' are passed over; the
/// names, too, may stand behind one. Throws InputError with file and line for anything
/// else.
std::vector<Vector3> read_nodal_csv(const std::filesystem::path& file, const Mesh& mesh,
                                    NodalQuantity quantity);

}  // namespace springcheck
