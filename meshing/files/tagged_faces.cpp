#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "meshing/cell_geometry.hpp"
#include "meshing/files/tagged_cells.hpp"
#include "meshing/input_error.hpp"

namespace springcheck {
namespace {

void check_jacobians(const TaggedCells& cells) {
  for (std::size_t c = 0; c < cells.cells.size(); ++c) {
    const double jacobian =
        smallest_corner_jacobian(corners(cells.cells[c], cells.nodes));
    if (!(jacobian > 0) || !std::isfinite(jacobian))
      throw InputError(cells.file, name_of_cell(cells, c),
                       "positive Jacobians at its corners",
                       fmt::format("{:.3g} m^3", jacobian));
  }
}

/// Whether two faces of the same nodes turn the same way round.
bool turn_alike(const FaceNodes& a, FaceNodes b) {
  std::ranges::rotate(b, std::ranges::find(b, a[0]));
  return a == b;
}

/// Of all cells, those that share one side by side.
std::vector<CellFace> sorted_faces(const TaggedCells& cells) {
  std::vector<CellFace> all;
  for (std::size_t c = 0; c < cells.cells.size(); ++c)
    for (const LocalFace& local : faces(type_of(cells.cells[c]))) {
      const FaceNodes face = face_nodes(cells.cells[c], local);
      all.push_back({.key = ascending(face), .face = face, .cell = c});
    }
  std::ranges::stable_sort(all, {}, &CellFace::key);
  return all;
}

/// Names a cell and, briefly, the other one in what was got.
void check_neighbours(const TaggedCells& cells, const CellFace& first,
                      const CellFace& second) {
  FaceNodes opposite = second.face;
  std::ranges::reverse(opposite);
  if (turn_alike(first.face, opposite)) return;
  throw InputError(cells.file, name_of_cell(cells, second.cell),
                   "its neighbour on the other side of each of its faces",
                   fmt::format("{} on the same side: the two overlap, or are one",
                               name_of_cell(cells, first.cell)));
}

}  // namespace

std::vector<CellFace> checked_boundary(const TaggedCells& cells) {
  check_jacobians(cells);
  const std::vector<CellFace> all = sorted_faces(cells);
  std::vector<CellFace> boundary;
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::ranges::find_if(
        first, all.end(), [&](const CellFace& face) { return face.key != first->key; });
    if (last - first == 1) boundary.push_back(*first);
    if (last - first > 1) check_neighbours(cells, first[0], first[1]);
    if (last - first > 2)
      throw InputError(cells.file, name_of_cell(cells, first[2].cell),
                       "at most two cells at each of its faces", "three");
    first = last;
  }
  return boundary;
}

std::map<std::string, std::vector<FaceNodes>> tagged_regions(
    const TaggedCells& cells, const MshFile& msh, const std::vector<CellFace>& boundary) {
  std::map<std::string, std::vector<FaceNodes>> regions;
  std::set<std::pair<std::string, FaceNodes>> found;
  for (const MshElement& element : msh.elements) {
    if (element.type->dimension != 2) continue;
    for (const std::int64_t group : msh.groups[element.groups]) {
      const auto named = msh.names.find({2, group});
      const std::string name = named == msh.names.end() || named->second.empty()
                                   ? std::to_string(group)
                                   : named->second;
      const auto refuse = [&](const char* expected, const char* got) {
        throw InputError(cells.file,
                         fmt::format("{} {} of surface '{}'", element.type->name,
                                     static_cast<std::int64_t>(element.tag), name),
                         expected, got);
      };
      FaceNodes face;
      for (const NodeTag tag : element.nodes)
        if (const auto node = find_node(cells, tag)) face.push_back(*node);
      const FaceNodes key = ascending(face);
      const auto place = std::ranges::lower_bound(boundary, key, {}, &CellFace::key);
      if (face.size() != element.nodes.size() || place == boundary.end() ||
          place->key != key)
        refuse("a face of exactly one cell", "a face inside the body, or of no cell");
      if (!found.insert({name, key}).second) refuse("each face once", "it twice");
      if (!turn_alike(face, place->face))
        std::ranges::reverse(face.begin() + 1, face.end());
      // Not even the other way round: a quadrilateral whose sides cross.
      if (!turn_alike(face, place->face))
        refuse("the nodes around the face", "them across it");
      regions[name].push_back(face);
    }
  }
  return regions;
}

}  // namespace springcheck
