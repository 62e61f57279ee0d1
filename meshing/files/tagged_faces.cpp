#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "meshing/basics/input_error.hpp"
#include "meshing/cell_geometry.hpp"
#include "meshing/files/tagged_cells.hpp"

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

/// The faces of all cells, sorted so that the uses of one face stand side by side.
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

/// Throws InputError where two cells lie on the same side of a face. It names one cell
/// and, briefly, the other one in what was got.
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

/// The name of a physical group, or its number where it has no name.
std::string name_of_group(const MshFile& msh, int dimension, std::int64_t group) {
  const auto named = msh.names.find({dimension, group});
  return named == msh.names.end() || named->second.empty() ? std::to_string(group)
                                                           : named->second;
}

/// The face turned outward, as the cell has it; `refuse` throws.
FaceNodes outward(FaceNodes face, const CellFace& of_cell, const auto& refuse) {
  if (!turn_alike(face, of_cell.face)) std::ranges::reverse(face.begin() + 1, face.end());
  // A quadrilateral whose sides cross is not alike the other way round either.
  if (!turn_alike(face, of_cell.face))
    refuse("the nodes around the face", "them across it");
  return face;
}

}  // namespace

std::vector<CellFace> checked_boundary(const TaggedCells& cells) {
  check_jacobians(cells);
  const std::vector<CellFace> all = sorted_faces(cells);
  std::vector<CellFace> boundary;
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::ranges::find_if(
        first, all.end(), [&](const CellFace& face) { return face.key != first->key; });
    if (last - first > 1) check_neighbours(cells, first[0], first[1]);
    if (last - first > 2)
      throw InputError(cells.file, name_of_cell(cells, first[2].cell),
                       "at most two cells at each of its faces", "three");
    if (last - first == 1) boundary.push_back(*first);
    first = last;
  }
  return boundary;
}

TaggedSurfaces tagged_surfaces(const TaggedCells& cells, const MshFile& msh,
                               const std::vector<CellFace>& boundary) {
  TaggedSurfaces surfaces;
  std::set<std::pair<std::string, FaceNodes>> found;
  for (const MshElement& element : msh.elements) {
    if (element.type->dimension != 2) continue;
    for (const std::int64_t group : msh.groups[element.groups]) {
      const std::string name = name_of_group(msh, 2, group);
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
      const bool is_of_boundary = face.size() == element.nodes.size() &&
                                  place != boundary.end() && place->key == key;
      if (!is_of_boundary) {
        surfaces.elsewhere.insert(name);
        continue;
      }
      if (!found.insert({name, key}).second) refuse("each face once", "it twice");
      surfaces.regions[name].push_back(outward(face, *place, refuse));
    }
  }
  for (const std::string& name : surfaces.elsewhere) surfaces.regions.erase(name);
  return surfaces;
}

std::set<std::string> volumes_apart(const MshFile& msh) {
  // Version 2.2 lists a cell once for each of its groups.
  std::map<ShortList<NodeTag, 8>, std::set<std::string>> names_of;
  for (const MshElement& element : msh.elements)
    if (element.type->dimension == 3)
      for (const std::int64_t group : msh.groups[element.groups])
        names_of[element.nodes].insert(name_of_group(msh, 3, group));
  std::set<std::string> names;
  bool are_apart = false;
  for (const auto& [cell, of_cell] : names_of) {
    are_apart = are_apart || of_cell != names_of.begin()->second;
    names.insert(of_cell.begin(), of_cell.end());
  }
  return are_apart ? names : std::set<std::string>{};
}

}  // namespace springcheck
