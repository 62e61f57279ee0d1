#include "meshing/files/vtu_writer.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace springcheck {
namespace {

// {} prints the shortest decimal that reads back as the same double.

int vtk_type(CellType type) {
  switch (type) {
    case CellType::tetrahedron:
      return 10;
    case CellType::pyramid:
      return 14;
    case CellType::prism:
      return 13;
    default:
      return 12;
  }
}

/// VTK's wedge stands on the other side of its first triangle.
CellNodes in_vtk_order(const CellNodes& cell) {
  if (type_of(cell) != CellType::prism) return cell;
  return {cell[0], cell[2], cell[1], cell[3], cell[5], cell[4]};
}

}  // namespace

void write_vtu(const Mesh& mesh, std::ostream& out) {
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
    fmt::print(out, "{}\n", fmt::join(in_vtk_order(cell), " "));
  fmt::print(out,
             "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" "
             "format=\"ascii\">\n");
  for (std::size_t end = 0; const CellNodes& cell : mesh.cells())
    fmt::print(out, "{}\n", end += cell.size());
  fmt::print(
      out, "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n");
  for (const CellNodes& cell : mesh.cells())
    fmt::print(out, "{}\n", vtk_type(type_of(cell)));
  fmt::print(out, "</DataArray>\n</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace springcheck
