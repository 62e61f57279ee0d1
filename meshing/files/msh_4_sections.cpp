#include <fmt/format.h>

#include "meshing/files/msh_sections.hpp"

namespace springcheck {
namespace {

using Int = std::int32_t;
using Size = std::uint64_t;

/// Bytes that so many numbers take at least.
std::size_t bytes(const MshCursor& cursor, std::size_t ints, std::size_t longer) {
  return cursor.is_binary() ? 4 * ints + 8 * longer : 2 * (ints + longer);
}

void check_total(MshCursor& cursor, std::size_t expected, std::size_t got) {
  if (expected != got)
    cursor.refuse(fmt::format("the blocks to have {} in all", expected),
                  std::to_string(got));
}

/// Reads what follows the number of blocks of nodes or elements: the number of all of
/// them, which is returned to be checked at the end, and two numbers that say nothing
/// new.
std::size_t read_total(MshCursor& cursor, std::size_t numbers_each) {
  const std::size_t total = cursor.count<Size>(bytes(cursor, 0, numbers_each));
  cursor.number<Size>();
  cursor.number<Size>();
  return total;
}

}  // namespace

EntityGroups read_entities_4(MshCursor& cursor, MshFile& msh) {
  EntityGroups entities;
  std::array<std::size_t, 4> counts{};
  for (std::size_t& count : counts) count = cursor.count<Size>(bytes(cursor, 1, 4));
  for (std::size_t dimension = 0; dimension < 4; ++dimension)
    for (std::size_t i = 0; i < counts[dimension]; ++i) {
      const std::int64_t entity = cursor.number<Int>();
      const int place_or_box = dimension == 0 ? 3 : 6;
      for (int k = 0; k < place_or_box; ++k) cursor.real();
      std::vector<std::int64_t> groups(cursor.count<Size>(bytes(cursor, 1, 0)));
      for (std::int64_t& group : groups)
        group = group_number(cursor, cursor.number<Int>());
      if (dimension > 0) {
        const std::size_t sides = cursor.count<Size>(bytes(cursor, 1, 0));
        for (std::size_t k = 0; k < sides; ++k) cursor.number<Int>();
      }
      entities[{static_cast<std::int64_t>(dimension), entity}] = msh.groups.size();
      msh.groups.push_back(std::move(groups));
    }
  return entities;
}

void read_nodes_4(MshCursor& cursor, MshFile& msh) {
  const std::size_t blocks = cursor.count<Size>(bytes(cursor, 3, 1));
  const std::size_t total = read_total(cursor, 4);
  msh.nodes.reserve(total);
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::int64_t dimension = cursor.number<Int>();
    cursor.number<Int>();  // the entity's number
    const bool has_parameters = cursor.number<Int>() != 0;
    if (dimension < 0 || dimension > 3)
      cursor.refuse("a block of dimension 0 to 3", std::to_string(dimension));
    const std::size_t count = cursor.count<Size>(bytes(cursor, 0, 4));
    std::vector<NodeTag> tags;
    for (std::size_t i = 0; i < count; ++i)
      tags.push_back(NodeTag{cursor.number<Size>()});
    for (const NodeTag tag : tags) {
      const double x = cursor.real(), y = cursor.real(), z = cursor.real();
      if (has_parameters)
        for (std::int64_t k = 0; k < dimension; ++k) cursor.real();
      msh.nodes.push_back({.tag = tag, .position = {x, y, z}});
    }
  }
  check_total(cursor, total, msh.nodes.size());
}

void read_elements_4(MshCursor& cursor, const EntityGroups& entities, MshFile& msh) {
  const std::size_t blocks = cursor.count<Size>(bytes(cursor, 3, 1));
  const std::size_t total = read_total(cursor, 2);
  msh.elements.reserve(total);
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::int64_t dimension = cursor.number<Int>(), entity = cursor.number<Int>();
    const MshType& type = known_type(cursor, cursor.number<Int>());
    const auto groups = entities.find({dimension, entity});
    if (type.dimension != dimension)
      cursor.refuse(
          fmt::format("elements of dimension {} in entity {}", dimension, entity),
          fmt::format("gmsh's type {}", type.number));
    if (groups == entities.end() && !entities.empty())
      cursor.refuse(
          fmt::format("entity {} of dimension {} in $Entities", entity, dimension),
          "none");
    const std::size_t count = cursor.count<Size>(bytes(cursor, 0, 1 + type.nodes));
    for (std::size_t i = 0; i < count; ++i) {
      MshElement element{.tag = ElementTag{cursor.number<Size>()},
                         .type = &type,
                         .groups = groups == entities.end() ? 0 : groups->second};
      for (std::size_t n = 0; n < type.nodes; ++n)
        element.nodes.push_back(NodeTag{cursor.number<Size>()});
      msh.elements.push_back(element);
    }
  }
  check_total(cursor, total, msh.elements.size());
}

}  // namespace springcheck
