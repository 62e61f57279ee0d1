#include "meshing/gmsh.hpp"

#include <gmsh.h>

#include <fstream>

#include "meshing/gmsh_session.hpp"

namespace springcheck {
namespace {

constexpr int gmsh_quadrilateral = 3;  // gmsh's element type numbers
constexpr int gmsh_hexahedron = 5;

bool ends_with(const std::filesystem::path& file, std::string_view ending) {
  std::ifstream in(file, std::ios::binary);
  in.seekg(-static_cast<std::streamoff>(ending.size()), std::ios::end);
  std::string last(ending.size(), '\0');
  in.read(last.data(), static_cast<std::streamsize>(last.size()));
  return in && last == ending;
}

}  // namespace

std::string gmsh_version() {
  const GmshSession session("version");
  std::string version;
  ::gmsh::option::getString("General.Version", version);
  return version;
}

void write_msh(const Mesh& mesh, const std::filesystem::path& file) try {
  const GmshSession session("mesh");
  ::gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
  const int volume = ::gmsh::model::addDiscreteEntity(3);

  std::vector<std::size_t> tags;
  std::vector<double> coordinates;
  for (std::size_t n = 0; n < mesh.nodes().size(); ++n) {
    tags.push_back(n + 1);
    for (const double x : mesh.nodes()[n]) coordinates.push_back(x);
  }
  ::gmsh::model::mesh::addNodes(3, volume, tags, coordinates);

  std::size_t next_element = 1;
  const auto add_elements = [&](int entity, int type, const auto& cells) {
    std::vector<std::size_t> element_tags, element_nodes;
    for (const auto& cell : cells) {
      element_tags.push_back(next_element++);
      for (const NodeIndex node : cell) element_nodes.push_back(node + 1);
    }
    ::gmsh::model::mesh::addElementsByType(entity, type, element_tags, element_nodes);
  };
  add_elements(volume, gmsh_hexahedron, mesh.cells());
  ::gmsh::model::setPhysicalName(3, ::gmsh::model::addPhysicalGroup(3, {volume}), "body");
  for (const auto& [name, region] : mesh.regions()) {
    const int surface = ::gmsh::model::addDiscreteEntity(2);
    add_elements(surface, gmsh_quadrilateral, region.faces);
    ::gmsh::model::setPhysicalName(2, ::gmsh::model::addPhysicalGroup(2, {surface}),
                                   name);
  }
  ::gmsh::write(file.string());
  if (!ends_with(file, "$EndElements\n"))  // gmsh does not tell of a full disk
    throw std::runtime_error(file.string() + ": could not be written whole (disk full?)");
} catch (const std::string& message) {
  throw std::runtime_error("gmsh: " + message);
}

}  // namespace springcheck
