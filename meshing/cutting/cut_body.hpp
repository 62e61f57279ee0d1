#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meshing/cutting/cell_complex.hpp"
#include "meshing/mesh.hpp"

namespace springcheck {

/// What a cut does to a body.
struct Cut {
  std::string name;                      // that new regions have
  std::vector<CellSide> parted{};        // as the cells below the cut have them
  std::vector<std::uint32_t> removed{};  // cells
};

/// A body that was cut, and where its nodes and cells come from.
struct CutBody {
  Mesh mesh;
  std::vector<NodeIndex> node_origin;      // in the body before, of each node
  std::vector<std::uint32_t> cell_origin;  // in the body before, of each cell
};

/// The body, whose cells hang together as `cells` says, with faces parted, cells removed.
/// Nodes and cells keep their order; copies of nodes stand behind all others. Regions
/// lose faces of removed cells, and go when none is left. New ones are NAME-below and
/// NAME-above, the two sides of the parted faces, and NAME, faces of cells that stay
/// against removed ones. A face stays one where, past the cut's end, the cells around
/// each of its nodes hang together.
///
/// Throws InputError, of `source`, unless each parted face lies between two cells, none
/// is named twice, one of them has two sides then, a cell is left, and the body has no
/// region of a new one's name.
CutBody cut(const std::string& source, const Mesh& body, CellComplex cells,
            const Cut& cut);

}  // namespace springcheck
