#include "comparisons/xdmf.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <set>

#include "meshing/output_file.hpp"

namespace springcheck {
namespace {

std::string grid_name(const CaseResult& result) {
  const CaseSettings& settings = result.request.settings;
  std::string name = fmt::format("{} {} nu={:g}", settings.scene, label(settings),
                                 settings.material.poisson_ratio);
  if (settings.deformation)
    name += fmt::format(" deformation={:g}", *settings.deformation);
  return fmt::format("{} {}", name, result.key.substr(0, 8));
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

void write_grids(std::ostream& out, const std::string& data,
                 const std::vector<CaseResult>& results, MeshStore& meshes) {
  fmt::print(out, "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n");
  std::set<std::string> written;
  for (const CaseResult& result : results) {
    if (result.solution.displacements.empty() || !written.insert(result.key).second)
      continue;
    const Mesh& mesh = meshes.mesh(result.request.settings.block);
    const std::size_t nodes = mesh.nodes().size(), cells = mesh.hexahedra().size();
    const std::string in_mesh = fmt::format("{}:/meshes/{}", data, mesh.sha256());
    const std::string in_case = fmt::format("{}:/cases/{}", data, result.key);
    const std::string partial = result.measures.volume_error ? "" : "partial_";
    fmt::print(out,
               "<Grid Name=\"{}\">\n"
               "<Topology TopologyType=\"Hexahedron\" NumberOfElements=\"{}\">"
               "<DataItem Format=\"HDF\" NumberType=\"UInt\" Dimensions=\"{} 8\">"
               "{}/hexahedra</DataItem></Topology>\n"
               "<Geometry GeometryType=\"XYZ\"><DataItem Format=\"HDF\" "
               "NumberType=\"Float\" Precision=\"8\" Dimensions=\"{} 3\">"
               "{}/nodes</DataItem></Geometry>\n",
               escaped(grid_name(result)), cells, cells, in_mesh, nodes, in_mesh);
    for (const char* field : {"displacement", "reaction"})
      fmt::print(out,
                 "<Attribute Name=\"{0}{1}\" AttributeType=\"Vector\" Center=\"Node\">"
                 "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" "
                 "Dimensions=\"{2} 3\">{3}/{0}{1}</DataItem></Attribute>\n",
                 partial, field, nodes, in_case);
    fmt::print(out,
               "<Attribute Name=\"{0}cell_volume_ratio\" AttributeType=\"Scalar\" "
               "Center=\"Cell\"><DataItem Format=\"HDF\" NumberType=\"Float\" "
               "Precision=\"8\" Dimensions=\"{1}\">{2}/{0}cell_volume_ratio</DataItem>"
               "</Attribute>\n</Grid>\n",
               partial, cells, in_case);
  }
  fmt::print(out, "</Domain>\n</Xdmf>\n");
}

}  // namespace

void write_xdmf(const std::filesystem::path& file, const std::string& data,
                const std::vector<CaseResult>& results, MeshStore& meshes) {
  write_whole_stream(
      file, [&](std::ostream& out) { write_grids(out, escaped(data), results, meshes); });
}

}  // namespace springcheck
