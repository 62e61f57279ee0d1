#include <fmt/format.h>

#include "meshing/cell_geometry.hpp"
#include "mss/networks/box_lattice.hpp"
#include "mss/networks/network.hpp"
#include "mss/networks/spring_model_table.hpp"

namespace springcheck::mss {
namespace {

/// Why the cell has no springs of the lattices made for hexahedra. Numbers are from 1.
std::optional<std::string> reason_against(std::size_t index, const CornerPositions& x,
                                          CellShapes shapes) {
  const bool takes_boxes = shapes == CellShapes::boxes;
  const char* shape = takes_boxes ? "box-shaped" : "cubic";
  const CellType type = type_with(static_cast<std::size_t>(x.cols()));
  if (type != CellType::hexahedron)
    return fmt::format("its springs need {} cells, and cell {} is a {}", shape, index + 1,
                       name_of(type));
  const auto box = box_edges(x);
  if (!box || (!takes_boxes && !is_cube(*box)))
    return fmt::format("its springs need {} cells, and hexahedron {} is none", shape,
                       index + 1);
  if (!is_cube(*box) && !box_lattice(1, *box))
    return fmt::format(
        "no springs without a negative stiffness make hexahedron {}, a box of {:.4g} : "
        "{:.4g} : {:.4g}, isotropic",
        index + 1, 1., (*box)[1] / (*box)[0], (*box)[2] / (*box)[0]);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> reason_to_refuse(const Mesh& mesh, const Material& material,
                                            SpringModel model) {
  const SpringModelEntry& entry = entry_of(model);
  if (entry.refuses != nullptr)
    if (auto reason = entry.refuses(material)) return reason;
  if (entry.cells == CellShapes::any) return std::nullopt;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const CellType type = type_of(mesh.cells()[c]);
    if (entry.cells != CellShapes::tetrahedra) {
      if (auto reason =
              reason_against(c, corners(mesh.cells()[c], mesh.nodes()), entry.cells))
        return reason;
    } else if (type != CellType::tetrahedron) {
      return fmt::format("its springs need tetrahedra, and cell {} is a {}", c + 1,
                         name_of(type));
    }
  }
  return std::nullopt;
}

}  // namespace springcheck::mss
