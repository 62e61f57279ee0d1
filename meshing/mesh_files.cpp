#include "meshing/mesh_files.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <map>

#include "meshing/gmsh.hpp"
#include "meshing/cell_geometry.hpp"
#include "meshing/input_error.hpp"
#include "meshing/output_file.hpp"

namespace springcheck {
namespace {

// {} prints the shortest decimal that reads back as the same double.

void write_vtu(const Mesh& mesh, std::ostream& out) {
  constexpr int vtk_hexahedron = 12;
  fmt::print(out,
             "<?xml version=\"1.0\"?>\n"
             "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n<UnstructuredGrid>\n"
             "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n"
             "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" "
             "format=\"ascii\">\n",
             mesh.nodes().size(), mesh.cells().size());
  for (const Vector3& x : mesh.nodes())
    fmt::print(out, "{} {} {}\n", x.x(), x.y(), x.z());
  fmt::print(out,
             "</DataArray>\n</Points>\n<Cells>\n"
             "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n");
  for (const CellNodes& cell : mesh.cells())
    fmt::print(out, "{}\n", fmt::join(cell, " "));
  fmt::print(out,
             "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" "
             "format=\"ascii\">\n");
  for (std::size_t c = 1; c <= mesh.cells().size(); ++c)
    fmt::print(out, "{}\n", 8 * c);
  fmt::print(
      out, "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n");
  for (std::size_t c = 0; c < mesh.cells().size(); ++c)
    fmt::print(out, "{}\n", vtk_hexahedron);
  fmt::print(out, "</DataArray>\n</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}

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

/// The cells at the faces of the regions, by the faces' ascending nodes.
std::map<FaceNodes, InpFace> faces_of_cells(const Mesh& mesh) {
  constexpr std::array<int, 6> labels{1, 2, 3, 5, 6, 4};  // of our faces
  std::map<FaceNodes, InpFace> found;
  for (const auto& [name, region] : mesh.regions())
    for (const FaceNodes& face : region.faces) found[ascending(face)] = {0, 0};
  for (std::size_t c = 0; c < mesh.cells().size(); ++c)
    for (std::size_t f = 0; f < 6; ++f) {
      const FaceNodes face = face_nodes(mesh.cells()[c], faces(CellType::hexahedron)[f]);
      if (const auto place = found.find(ascending(face)); place != found.end())
        place->second = {c + 1, labels[f]};
    }
  return found;
}

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
  fmt::print(out, "*ELEMENT, TYPE=C3D8, ELSET=Eall\n");
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
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

}  // namespace

void write_mesh(const Mesh& mesh, const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".msh")
    write_whole(file, [&](const std::filesystem::path& unfinished) {
      write_msh(mesh, unfinished);
    });
  else if (extension == ".vtu")
    write_whole_stream(file, [&](std::ostream& out) { write_vtu(mesh, out); });
  else if (extension == ".inp")
    write_whole_stream(file, [&](std::ostream& out) { write_inp(mesh, out); });
  else
    throw InputError(file.string(), "extension", ".msh, .vtu or .inp",
                     extension.empty() ? "none" : extension);
}

}  // namespace springcheck
