#include "meshing/cutting/cut_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

using FacesByRegion = std::map<std::string, std::vector<CellSide>>;

std::string name_of(const CellSide& face) {
  return fmt::format("face {} of cell {}", face.face + 1, face.cell + 1);
}

/// What is named twice in the list, sorted, or its end.
template <class List>
auto repeated_in(List& list) {
  std::ranges::sort(list);
  return std::ranges::adjacent_find(list);
}

void check(const std::string& source, const std::string& place, const CellComplex& cells,
           const Cut& cut) {
  std::vector<CellSide> sides;
  for (const CellSide& face : cut.parted) {
    if (face.cell >= cells.cell_count() || face.face >= cells.face_count(face.cell))
      throw InputError(source, place, "a face of the body", name_of(face));
    if (cells.across(face) == CellComplex::none)
      throw InputError(source, place, "a face between two cells",
                       name_of(face) + ", which has one");
    sides.push_back(face);
    sides.push_back(cells.other_side(face));
  }
  if (const auto twice = repeated_in(sides); twice != sides.end())
    throw InputError(source, place, "each face once", name_of(*twice) + " twice");
  std::vector<std::uint32_t> removed = cut.removed;
  if (const auto twice = repeated_in(removed); twice != removed.end())
    throw InputError(source, place, "each cell once",
                     fmt::format("cell {} twice", *twice + 1));
  if (!removed.empty() && removed.back() >= cells.cell_count())
    throw InputError(source, place, fmt::format("cells up to {}", cells.cell_count()),
                     fmt::format("cell {}", removed.back() + 1));
  if (removed.size() == cells.cell_count())
    throw InputError(source, place, "at least one cell that stays", "none");
}

FacesByRegion faces_of_regions(const Mesh& body, const CellComplex& cells) {
  FacesByRegion regions;
  for (const auto& [name, region] : body.regions())
    for (const FaceNodes& face : region.faces)
      regions[name].push_back(cells.face_with(face));
  return regions;
}

/// The surfaces that the cut makes.
FacesByRegion faces_of_cut(const CellComplex& cells, const Cut& cut) {
  FacesByRegion made;
  for (const CellSide& face : cut.parted) {
    made[cut.name + "-below"].push_back(face);
    made[cut.name + "-above"].push_back(cells.other_side(face));
  }
  std::vector<std::uint32_t> removed = cut.removed;
  std::ranges::sort(removed);
  for (const std::uint32_t cell : removed)
    for (std::uint8_t f = 0; f < cells.face_count(cell); ++f) {
      const CellSide face{cell, f};
      const std::uint32_t other = cells.across(face);
      if (other != CellComplex::none && !std::ranges::binary_search(removed, other))
        made[cut.name].push_back(cells.other_side(face));
    }
  return made;
}

/// Takes the sides of faces away that have no two sides, as their nodes stay joined.
void keep_open(const CellComplex& cells, const Cut& cut, FacesByRegion& made) {
  const auto below = made.extract(cut.name + "-below"),
             above = made.extract(cut.name + "-above");
  if (below.empty()) return;
  for (std::size_t i = 0; i < below.mapped().size(); ++i) {
    const CellSide &lower = below.mapped()[i], &upper = above.mapped()[i];
    if (ascending(cells.nodes_of(lower)) == ascending(cells.nodes_of(upper))) continue;
    made[below.key()].push_back(lower);
    made[above.key()].push_back(upper);
  }
}

/// The mesh of what is left.
CutBody body_of(const Mesh& before, const CellComplex& cells,
                const FacesByRegion& regions) {
  std::vector<NodeIndex> node_origin, number(cells.node_count());
  std::vector<Vector3> nodes;
  for (NodeIndex n = 0; n < cells.node_count(); ++n) {
    if (cells.cells_at(n).empty()) continue;
    number[n] = static_cast<NodeIndex>(nodes.size());
    node_origin.push_back(cells.origin(n));
    nodes.push_back(before.nodes()[cells.origin(n)]);
  }
  const auto renumbered = [&](auto list) {
    for (NodeIndex& node : list) node = number[node];
    return list;
  };
  std::vector<std::uint32_t> cell_origin;
  std::vector<CellNodes> left;
  for (std::uint32_t c = 0; c < cells.cell_count(); ++c) {
    if (cells.is_removed(c)) continue;
    cell_origin.push_back(c);
    left.push_back(renumbered(cells.nodes_of(c)));
  }
  std::map<std::string, std::vector<FaceNodes>> faces;
  for (const auto& [name, region] : regions)
    for (const CellSide& face : region)
      if (!cells.is_removed(face.cell))
        faces[name].push_back(renumbered(cells.nodes_of(face)));
  return {.mesh = Mesh(before.source(), std::move(nodes), std::move(left),
                       std::move(faces), before.surfaces_elsewhere()),
          .node_origin = std::move(node_origin),
          .cell_origin = std::move(cell_origin)};
}

}  // namespace

CutBody cut(const std::string& source, const Mesh& body, CellComplex cells,
            const Cut& cut) {
  const std::string place = fmt::format("cut '{}'", cut.name);
  check(source, place, cells, cut);
  FacesByRegion regions = faces_of_regions(body, cells);
  FacesByRegion made = faces_of_cut(cells, cut);
  cells.part(cut.parted);
  keep_open(cells, cut, made);
  if (!cut.parted.empty() && made.empty() && cut.removed.empty())
    throw InputError(source, place, "a cut at least two faces wide, or to the surface",
                     fmt::format("{} faces whose nodes all stay joined around its end",
                                 cut.parted.size()));
  for (auto& [name, faces] : made)
    if (!regions.emplace(name, std::move(faces)).second)
      throw InputError(source, place, "a name of its own for each surface",
                       fmt::format("a second one of '{}'", name));
  cells.remove(cut.removed);
  return body_of(body, cells, regions);
}

}  // namespace springcheck
