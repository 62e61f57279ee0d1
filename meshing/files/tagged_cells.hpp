#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "meshing/files/msh_file.hpp"

namespace springcheck {

/// The cells of a .msh file, numbered as a Mesh will number them, with the file's tags
/// for those who read the errors.
struct TaggedCells {
  std::string file;
  std::vector<NodeTag> node_tags{};  // ascending, of the nodes that the cells use
  std::vector<Vector3> nodes{};      // [m]
  std::vector<ElementTag> cell_tags{};
  std::vector<CellNodes> cells{};  // tetrahedra first, as Mesh sorts them
};

/// The cells of those three-dimensional elements of the file that are in a physical
/// group, or of all when none is. Throws InputError for none at all, nodes that are given
/// twice or not at all, those that no element uses, and coordinates that are not finite.
TaggedCells tagged_cells(const std::string& file, const MshFile& msh,
                         double metres_per_unit);

/// Number of the node with the tag, or none when the cells do not use it.
std::optional<NodeIndex> find_node(const TaggedCells& cells, NodeTag tag);

std::string name_of_node(const TaggedCells& cells, NodeIndex node);  // "node 17"

/// "tetrahedron 17 near (1, 2, 3) m"
std::string name_of_cell(const TaggedCells& cells, std::size_t cell);

/// A cell's face, and where it is to be found.
struct CellFace {
  FaceNodes key;   // ascending
  FaceNodes face;  // outward
  std::size_t cell;
};

/// The faces of exactly one cell, by ascending keys. Throws InputError for cells that are
/// flat, turned over or huge beyond numbers, that lie on the same side of a face, and for
/// third ones at a face.
std::vector<CellFace> checked_boundary(const TaggedCells& cells);

/// The file's physical surfaces, by name, or by number where they have none.
struct TaggedSurfaces {
  std::map<std::string, std::vector<FaceNodes>> regions{};  // outward
  std::set<std::string> elsewhere{};  // not on the boundary of those cells throughout
};

/// The physical surfaces of the file. Throws InputError for boundary faces that one of
/// them has twice, or across its nodes.
TaggedSurfaces tagged_surfaces(const TaggedCells& cells, const MshFile& msh,
                               const std::vector<CellFace>& boundary);

/// Names of the physical volumes, or their numbers, where not all cells belong to the
/// same ones.
std::set<std::string> volumes_apart(const MshFile& msh);

}  // namespace springcheck
