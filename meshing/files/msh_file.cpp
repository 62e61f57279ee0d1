#include "meshing/files/msh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <limits>
#include <set>

#include "meshing/basics/text.hpp"
#include "meshing/files/msh_cursor.hpp"
#include "meshing/files/msh_sections.hpp"

namespace springcheck {
namespace {

constexpr std::array<MshType, 8> types{{{1, 1, 2, "line"},
                                        {2, 2, 3, "triangle"},
                                        {3, 2, 4, "quadrilateral"},
                                        {4, 3, 4, "tetrahedron"},
                                        {5, 3, 8, "hexahedron"},
                                        {6, 3, 6, "prism"},
                                        {7, 3, 5, "pyramid"},
                                        {15, 0, 1, "point"}}};

/// Returns whether it is version 4.1, not 2.2.
bool read_format(MshCursor& cursor) {
  cursor.set_entity("first line");
  if (const auto start = cursor.word(); start != "$MeshFormat")
    cursor.refuse("'$MeshFormat' of a mesh (gmsh -3 BODY.geo -o BODY.msh makes one)",
                  quotation(start));
  cursor.set_entity("$MeshFormat");
  const std::string version(cursor.word());
  if (version != "2.2" && version != "4.1")
    cursor.refuse("version 2.2 or 4.1", quotation(version));
  const std::int64_t is_binary = cursor.text_number();
  if (is_binary != 0 && is_binary != 1)
    cursor.refuse("file type 0 or 1", std::to_string(is_binary));
  if (const auto size = cursor.text_number(); size != 8)
    cursor.refuse("data size 8", std::to_string(size));
  if (is_binary == 1) {
    cursor.skip_line_end();
    cursor.set_binary();
    if (const auto one = cursor.number<std::int32_t>(); one != 1)
      cursor.refuse("1 in this machine's byte order", std::to_string(one));
  }
  expect_end(cursor, "$MeshFormat");
  return version == "4.1";
}

void read_names(MshCursor& cursor, MshFile& msh) {
  const std::size_t count = cursor.text_count(6);  // 2 1 ""
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t dimension = cursor.text_number(), number = cursor.text_number();
    msh.names[{dimension, number}] = cursor.quoted();
  }
}

}  // namespace

const MshType* msh_type(std::int64_t number) {
  const auto* found = std::ranges::find(types, number, &MshType::number);
  return found == types.end() ? nullptr : found;
}

int msh_number(CellType type) {
  return std::ranges::find(types, name_of(type), &MshType::name)->number;
}

int msh_number_of_face(std::size_t nodes) {
  return nodes == 3 ? 2 : 3;
}

void expect_end(MshCursor& cursor, const std::string& section) {
  const std::string end = "$End" + section.substr(1);
  if (const auto found = cursor.word(); found != end)
    cursor.refuse(quotation(end), quotation(found));
}

const MshType& known_type(MshCursor& cursor, std::int64_t number) {
  const MshType* type = msh_type(number);
  if (type == nullptr)
    cursor.refuse(
        "elements of first order: points, lines, triangles, quadrilaterals, "
        "tetrahedra, pyramids, prisms, hexahedra",
        "gmsh's type " + std::to_string(number));
  return *type;
}

std::int64_t group_number(MshCursor& cursor, std::int64_t signed_number) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (signed_number < -most || signed_number > most)
    cursor.refuse("a physical group of a number up to 2^31 - 1",
                  std::to_string(signed_number));
  return std::abs(signed_number);
}

MshFile parse_msh(const std::filesystem::path& file) {
  MshCursor cursor(file);
  const bool is_4 = read_format(cursor);
  MshFile msh{.groups = {{}}};
  EntityGroups entities;
  std::set<std::string> read;
  while (!cursor.at_end()) {
    cursor.set_entity("section");
    const std::string section(cursor.word());
    if (!section.starts_with('$') || section.starts_with("$End"))
      cursor.refuse("the start of a section", quotation(section));
    cursor.set_entity(section);
    if (section == "$PartitionedEntities")
      cursor.refuse("a mesh that is not partitioned", "this section");
    if (section == "$Entities" && read.contains("$Elements"))
      cursor.refuse("a place before $Elements", "one behind");
    const bool is_known = section == "$PhysicalNames" || section == "$Nodes" ||
                          section == "$Elements" || (is_4 && section == "$Entities");
    if (!is_known) {
      cursor.skip_behind("$End" + section.substr(1));
      continue;
    }
    if (!read.insert(section).second) cursor.refuse("the section once", "it twice");
    cursor.skip_line_end();
    if (section == "$PhysicalNames")
      read_names(cursor, msh);
    else if (section == "$Entities")
      entities = read_entities_4(cursor, msh);
    else if (section == "$Nodes")
      is_4 ? read_nodes_4(cursor, msh) : read_nodes_2(cursor, msh);
    else
      is_4 ? read_elements_4(cursor, entities, msh) : read_elements_2(cursor, msh);
    expect_end(cursor, section);
  }
  cursor.set_entity("");
  for (const char* section : {"$Nodes", "$Elements"})
    if (!read.contains(section))
      cursor.refuse(fmt::format("a section {}", section), "none");
  return msh;
}

}  // namespace springcheck
