#include "comparisons/results/stored_mesh.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "comparisons/results/xdmf_elements.hpp"
#include "comparisons/store/hdf5.hpp"

namespace springcheck {
namespace {

constexpr const char* xdmf_topology = "xdmf_topology";

struct CellTable {
  const char* name;
  CellType type;
  const char* xdmf_name;
  std::uint32_t xdmf_code;  // in a mixed topology
};
constexpr std::array<CellTable, 4> cell_tables{
    {{"tetrahedra", CellType::tetrahedron, "Tetrahedron", 6},
     {"pyramids", CellType::pyramid, "Pyramid", 7},
     {"prisms", CellType::prism, "Wedge", 8},
     {"hexahedra", CellType::hexahedron, "Hexahedron", 9}}};

/// XDMF's codes and nodes, cell by cell.
std::vector<std::uint32_t> mixed_topology(const std::vector<CellNodes>& cells) {
  std::vector<std::uint32_t> codes;
  for (const CellNodes& cell : cells) {
    const auto table = std::ranges::find(cell_tables, type_of(cell), &CellTable::type);
    codes.push_back(table->xdmf_code);
    if (type_of(cell) == CellType::prism)  // VTK's run around the other way
      for (const std::size_t i : {0, 2, 1, 3, 5, 4}) codes.push_back(cell[i]);
    else
      codes.insert(codes.end(), cell.begin(), cell.end());
  }
  return codes;
}

std::vector<std::uint32_t> face_table(const std::vector<FaceNodes>& faces) {
  std::vector<std::uint32_t> values;
  for (const FaceNodes& face : faces)
    for (std::size_t i = 0; i < 4; ++i)
      values.push_back(face[std::min(i, face.size() - 1)]);
  return values;
}

/// A region's name as HDF5 takes it for one link: "/" leads into groups, and "." is the
/// group itself. Such bytes as in URLs (RFC 3986, section 2.1), "%" with them.
std::string link_name(const std::string& region) {
  std::string name;
  for (const char c : region)
    name += c == '/' || c == '%' || region == "." ? fmt::format("%{:02X}", c)
                                                  : std::string(1, c);
  return name;
}

}  // namespace

void write_stored_mesh(hid_t meshes, const Mesh& mesh) {
  const auto group = hdf5::create_group(meshes, mesh.sha256());
  hdf5::write_attribute(group, "source", mesh.source());
  std::vector<double> coordinates;
  for (const Vector3& x : mesh.nodes())
    coordinates.insert(coordinates.end(), x.begin(), x.end());
  hdf5::write_table(group, "nodes", coordinates, 3);
  for (const CellTable& table : cell_tables) {
    std::vector<std::uint32_t> nodes;
    for (const CellNodes& cell : mesh.cells())
      if (type_of(cell) == table.type)
        nodes.insert(nodes.end(), cell.begin(), cell.end());
    if (!nodes.empty())
      hdf5::write_table(group, table.name, nodes, node_count(table.type));
  }
  if (mesh.count(CellType::prism) > 0 ||
      type_of(mesh.cells().front()) != type_of(mesh.cells().back()))
    hdf5::write_table(group, xdmf_topology, mixed_topology(mesh.cells()), 1);
  const auto regions = hdf5::create_group(group, "regions");
  for (const auto& [name, region] : mesh.regions())
    hdf5::write_table(regions, link_name(name), face_table(region.faces), 4);
}

std::size_t stored_cell_count(hid_t mesh) {
  std::size_t count = 0;
  for (const CellTable& table : cell_tables)
    if (hdf5::has_link(mesh, table.name))
      count += hdf5::row_count_of_table(mesh, table.name);
  return count;
}

void append_xdmf_mesh(pugi::xml_node grid, hid_t mesh, const std::string& in_mesh) {
  const std::string cells = fmt::to_string(stored_cell_count(mesh));
  std::string type = "Mixed", name = xdmf_topology, dimensions;
  if (hdf5::has_link(mesh, xdmf_topology)) {
    dimensions = fmt::to_string(hdf5::row_count_of_table(mesh, xdmf_topology));
  } else {
    const auto table = std::ranges::find_if(cell_tables, [&](const CellTable& candidate) {
      return hdf5::has_link(mesh, candidate.name);
    });
    if (table == cell_tables.end()) throw std::runtime_error(in_mesh + " has no cells");
    type = table->xdmf_name;
    name = table->name;
    dimensions = fmt::format("{} {}", cells, node_count(table->type));
  }
  append_data_item(append_element(grid, "Topology",
                                  {{"TopologyType", type}, {"NumberOfElements", cells}}),
                   dimensions, in_mesh + "/" + name, XdmfNumbers::whole);
  append_data_item(append_element(grid, "Geometry", {{"GeometryType", "XYZ"}}),
                   fmt::format("{} 3", hdf5::row_count_of_table(mesh, "nodes")),
                   in_mesh + "/nodes", XdmfNumbers::real);
}

}  // namespace springcheck
