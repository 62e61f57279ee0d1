#include <fmt/format.h>

#include "meshing/cell_geometry.hpp"
#include "mss/networks/box_lattice.hpp"
#include "mss/networks/network.hpp"

namespace springcheck::mss {
namespace {

bool takes_boxes(Method method) {
  return method == Method::cf || method == Method::fd;
}

bool takes_tetrahedra_alone(Method method) {
  return method == Method::vangelder || method == Method::lloyd;
}

/// Why the cell has no springs of the lattices made for hexahedra.
std::optional<std::string> reason_against(std::size_t number, const CornerPositions& x,
                                          Method method) {
  const char* shape = takes_boxes(method) ? "box-shaped" : "cubic";
  const CellType type = type_with(static_cast<std::size_t>(x.cols()));
  if (type != CellType::hexahedron)
    return fmt::format("its springs need {} cells, and cell {} is a {}", shape, number,
                       name_of(type));
  const auto box = box_edges(x);
  if (!box || (!takes_boxes(method) && !is_cube(*box)))
    return fmt::format("its springs need {} cells, and hexahedron {} is none", shape,
                       number);
  if (!is_cube(*box) && !box_lattice(1, *box))
    return fmt::format(
        "no springs without a negative stiffness make hexahedron {}, a box of {:.4g} : "
        "{:.4g} : {:.4g}, isotropic",
        number, 1., (*box)[1] / (*box)[0], (*box)[2] / (*box)[0]);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> reason_to_refuse(const Mesh& mesh, const Material& material,
                                            Method method) {
  if (method == Method::baudet && material.poisson_ratio <= -0.25)
    return fmt::format(
        "mss-baudet covers nu in (-0.25, 0.5): its edge stiffness is not positive at "
        "nu = {:g}",
        material.poisson_ratio);
  if (method == Method::affine) return std::nullopt;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const CellType type = type_of(mesh.cells()[c]);
    if (!takes_tetrahedra_alone(method)) {
      if (auto reason = reason_against(c, corners(mesh.cells()[c], mesh.nodes()), method))
        return reason;
    } else if (type != CellType::tetrahedron) {
      return fmt::format("its springs need tetrahedra, and cell {} is a {}", c,
                         name_of(type));
    }
  }
  return std::nullopt;
}

}  // namespace springcheck::mss
