#include "meshing/files/inp_writer.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <array>
#include <map>

namespace springcheck {
namespace {

/// x in at most 20 characters: CalculiX drops what follows them, be it the exponent. The
/// shortest decimal that reads back as the same double, or as many digits as there is
/// room for.
std::string inp_number(double x) {
  std::string text = fmt::format("{}", x);
  for (int digits = 16; text.size() > 20; --digits)
    text = fmt::format("{:.{}g}", x, digits);
  return text;
}

/// A face of a cell as CalculiX numbers both, from 1.
struct InpFace {
  std::size_t cell;
  int label;  // of S1 to S6
};

/// CalculiX's number of one of our faces: ours plus one, but for hexahedra.
int label(CellType type, std::size_t face) {
  constexpr std::array<int, 6> of_hexahedron{1, 2, 3, 5, 6, 4};
  return type == CellType::hexahedron ? of_hexahedron[face] : static_cast<int>(face) + 1;
}

/// The cells at the faces of the regions, by the faces' ascending nodes.
std::map<FaceNodes, InpFace> faces_of_cells(const Mesh& mesh) {
  std::map<FaceNodes, InpFace> found;
  for (const auto& [name, region] : mesh.regions())
    for (const FaceNodes& face : region.faces) found[ascending(face)] = {0, 0};
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const CellType type = type_of(mesh.cells()[c]);
    for (std::size_t f = 0; f < faces(type).size(); ++f) {
      const FaceNodes face = face_nodes(mesh.cells()[c], faces(type)[f]);
      if (const auto place = found.find(ascending(face)); place != found.end())
        place->second = {c + 1, label(type, f)};
    }
  }
  return found;
}

}  // namespace

void write_inp(const Mesh& mesh, std::ostream& out) {
  fmt::print(out,
             "** {}; lengths in m\n"
             "** Sets: all nodes Nall, all cells Eall; each region of the boundary is a\n"
             "** node set (for *BOUNDARY) and a surface (for *DSLOAD) of its name.\n"
             "** To be added: *MATERIAL, *SOLID SECTION, *STEP.\n"
             "*NODE, NSET=Nall\n",
             mesh.source());
  for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
    const Vector3& x = mesh.nodes()[n];
    fmt::print(out, "{}, {}, {}, {}\n", n + 1, inp_number(x.x()), inp_number(x.y()),
               inp_number(x.z()));
  }
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    const std::size_t nodes = mesh.cells()[c].size();
    if (c == 0 || nodes != mesh.cells()[c - 1].size())  // cells are sorted by type
      fmt::print(out, "*ELEMENT, TYPE=C3D{}, ELSET=Eall\n", nodes);
    fmt::print(out, "{}", c + 1);
    for (const NodeIndex node : mesh.cells()[c]) fmt::print(out, ", {}", node + 1);
    fmt::print(out, "\n");
  }
  const std::map<FaceNodes, InpFace> faces = faces_of_cells(mesh);
  for (const auto& [name, region] : mesh.regions()) {
    fmt::print(out, "*NSET, NSET={}\n", name);
    for (const NodeIndex node : region.nodes) fmt::print(out, "{},\n", node + 1);
    fmt::print(out, "*SURFACE, NAME={}, TYPE=ELEMENT\n", name);
    for (const FaceNodes& face : region.faces) {
      const auto [cell, label] = faces.at(ascending(face));
      fmt::print(out, "{}, S{}\n", cell, label);
    }
  }
}

}  // namespace springcheck
