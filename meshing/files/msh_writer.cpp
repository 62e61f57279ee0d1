#include "meshing/files/msh_writer.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <span>

#include "meshing/files/msh_file.hpp"

namespace springcheck {
namespace {

int number_of(const CellNodes& cell) {
  return msh_number(type_of(cell));
}
int number_of(const FaceNodes& face) {
  return msh_number_of_face(face.size());
}

/// One block of elements for each run of one type.
template <class List>
std::string element_blocks(int dimension, std::size_t entity,
                           std::span<const List> elements, std::size_t& next_tag,
                           std::size_t& blocks) {
  std::string text;
  for (auto first = elements.begin(); first != elements.end();) {
    const auto last = std::find_if(
        first, elements.end(), [&](const List& e) { return e.size() != first->size(); });
    text +=
        fmt::format("{} {} {} {}\n", dimension, entity, number_of(*first), last - first);
    for (; first != last; ++first) {
      text += fmt::format("{}", next_tag++);
      for (const NodeIndex node : *first) text += fmt::format(" {}", node + 1);
      text += '\n';
    }
    ++blocks;
  }
  return text;
}

}  // namespace

void write_msh(const Mesh& mesh, std::ostream& out) {
  fmt::print(out, "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
  fmt::print(out, "$PhysicalNames\n{}\n3 1 \"body\"\n", mesh.regions().size() + 1);
  std::size_t surface = 1;
  for (const auto& [name, region] : mesh.regions())
    fmt::print(out, "2 {} \"{}\"\n", ++surface, name);

  Eigen::AlignedBox3d box;
  for (const Vector3& x : mesh.nodes()) box.extend(x);
  const std::string extent =
      fmt::format("{} {} {} {} {} {}", box.min().x(), box.min().y(), box.min().z(),
                  box.max().x(), box.max().y(), box.max().z());
  // Entities have their physical groups' numbers, and no sides: nobody knows more.
  fmt::print(out, "$EndPhysicalNames\n$Entities\n0 0 {} 1\n", mesh.regions().size());
  for (std::size_t entity = 2; entity <= surface; ++entity)
    fmt::print(out, "{0} {1} 1 {0} 0\n", entity, extent);
  fmt::print(out, "1 {} 1 1 0\n$EndEntities\n", extent);

  fmt::print(out, "$Nodes\n1 {0} 1 {0}\n3 1 0 {0}\n", mesh.nodes().size());
  for (std::size_t n = 1; n <= mesh.nodes().size(); ++n) fmt::print(out, "{}\n", n);
  for (const Vector3& x : mesh.nodes())  // {}: shortest decimals that read back the same
    fmt::print(out, "{} {} {}\n", x.x(), x.y(), x.z());

  std::size_t next_tag = 1, blocks = 0, entity = 1;
  std::string elements =
      element_blocks<CellNodes>(3, entity, mesh.cells(), next_tag, blocks);
  for (const auto& [name, region] : mesh.regions())
    elements += element_blocks<FaceNodes>(2, ++entity, region.faces, next_tag, blocks);
  fmt::print(out, "$EndNodes\n$Elements\n{0} {1} 1 {1}\n{2}$EndElements\n", blocks,
             next_tag - 1, elements);
}

}  // namespace springcheck
