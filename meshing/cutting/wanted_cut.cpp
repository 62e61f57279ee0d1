#include "meshing/cutting/wanted_cut.hpp"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "meshing/loads/traction.hpp"

namespace springcheck {
MadeCut make_cut(const Mesh& body, const WantedCut& wanted) {
  CellComplex cells(body);
  const std::string place = fmt::format("cut '{}'", wanted.name);
  const std::string& source = wanted.place.empty() ? body.source() : wanted.place;
  Cut chosen{.name = wanted.name};
  CutFigures figures;
  if (wanted.kind == CutKind::remove) {
    chosen.removed = cells_within(source, place, cells, body.nodes(), wanted.where);
    figures.cells_removed = chosen.removed.size();
    for (const std::uint32_t cell : chosen.removed)
      figures.volume_removed += body.cell_volumes()[cell];
  } else {
    FaceChoice choice = faces_along(source, place, cells, body.nodes(), wanted.where);
    figures.farthest = choice.farthest;
    chosen.parted = std::move(choice.faces);
  }
  MadeCut made{.body = cut(source, body, std::move(cells), chosen), .figures = figures};
  if (wanted.kind == CutKind::split) {
    const Region& side = made.body.mesh.region(wanted.name + "-below");
    made.figures.faces_split = side.faces.size();
    const std::vector<double> areas = nodal_areas(made.body.mesh, side);
    made.figures.area = std::accumulate(areas.begin(), areas.end(), 0.);
  }
  std::vector<char> is_there(body.nodes().size(), 0);
  for (const NodeIndex origin : made.body.node_origin)
    if (std::exchange(is_there[origin], 1) != 0) ++made.figures.nodes_added;
  return made;
}

}  // namespace springcheck
