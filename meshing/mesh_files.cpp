#include "meshing/mesh_files.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "meshing/gmsh.hpp"
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
             mesh.nodes().size(), mesh.hexahedra().size());
  for (const Vector3& x : mesh.nodes())
    fmt::print(out, "{} {} {}\n", x.x(), x.y(), x.z());
  fmt::print(out,
             "</DataArray>\n</Points>\n<Cells>\n"
             "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n");
  for (const Hexahedron& cell : mesh.hexahedra())
    fmt::print(out, "{}\n", fmt::join(cell, " "));
  fmt::print(out,
             "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" "
             "format=\"ascii\">\n");
  for (std::size_t c = 1; c <= mesh.hexahedra().size(); ++c)
    fmt::print(out, "{}\n", 8 * c);
  fmt::print(
      out, "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n");
  for (std::size_t c = 0; c < mesh.hexahedra().size(); ++c)
    fmt::print(out, "{}\n", vtk_hexahedron);
  fmt::print(out, "</DataArray>\n</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}

void write_inp(const Mesh& mesh, std::ostream& out) {
  fmt::print(out, "** {}; lengths in m\n*NODE, NSET=Nall\n", mesh.source());
  for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
    const Vector3& x = mesh.nodes()[n];
    fmt::print(out, "{}, {}, {}, {}\n", n + 1, x.x(), x.y(), x.z());
  }
  fmt::print(out, "*ELEMENT, TYPE=C3D8, ELSET=Eall\n");
  for (std::size_t c = 0; c < mesh.hexahedra().size(); ++c) {
    fmt::print(out, "{}", c + 1);
    for (const NodeIndex node : mesh.hexahedra()[c]) fmt::print(out, ", {}", node + 1);
    fmt::print(out, "\n");
  }
  for (const auto& [name, region] : mesh.regions()) {
    fmt::print(out, "*NSET, NSET={}\n", name);
    for (const NodeIndex node : region.nodes) fmt::print(out, "{},\n", node + 1);
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
