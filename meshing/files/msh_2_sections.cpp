#include "meshing/files/msh_sections.hpp"

namespace springcheck {
namespace {

constexpr std::size_t text_bytes = 2;  // of a number at least: a digit and a space

/// Index in MshFile::groups of the physical group alone, 0 for none.
std::size_t set_of(std::int64_t group, std::map<std::int64_t, std::size_t>& sets,
                   MshFile& msh) {
  const auto [set, is_new] = sets.try_emplace(group, group == 0 ? 0 : msh.groups.size());
  if (is_new && group != 0) msh.groups.push_back({group});
  return set->second;
}

}  // namespace

void read_nodes_2(MshCursor& cursor, MshFile& msh) {
  const std::size_t count = cursor.text_count(cursor.is_binary() ? 28 : 4 * text_bytes);
  if (cursor.is_binary()) cursor.skip_line_end();
  msh.nodes.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const NodeTag tag{cursor.number<std::int32_t>()};
    const double x = cursor.real(), y = cursor.real(), z = cursor.real();
    msh.nodes.push_back({.tag = tag, .position = {x, y, z}});
  }
}

void read_elements_2(MshCursor& cursor, MshFile& msh) {
  const std::size_t count = cursor.text_count(cursor.is_binary() ? 8 : 4 * text_bytes);
  if (cursor.is_binary()) cursor.skip_line_end();
  msh.elements.reserve(count);
  std::map<std::int64_t, std::size_t> sets;
  while (msh.elements.size() < count) {
    // Binary files say the type and the number of tags once for several elements.
    std::size_t alike = 1;
    std::int64_t number = 0, type_number = 0;
    if (cursor.is_binary()) {
      type_number = cursor.number<std::int32_t>();
      alike = cursor.count<std::int32_t>(8);
    } else {
      number = cursor.text_number();
      type_number = cursor.text_number();
    }
    const MshType& type = known_type(cursor, type_number);
    const std::size_t tags =
        cursor.count<std::int32_t>(cursor.is_binary() ? 4 : text_bytes);
    if (alike == 0 || alike > count - msh.elements.size())
      cursor.refuse(std::to_string(count) + " elements", "another number");
    for (std::size_t i = 0; i < alike; ++i) {
      if (cursor.is_binary()) number = cursor.number<std::int32_t>();
      std::int64_t group = 0;
      for (std::size_t tag = 0; tag < tags; ++tag) {
        const std::int64_t value = cursor.number<std::int32_t>();
        if (tag == 0) group = group_number(cursor, value);
      }
      MshElement element{
          .tag = ElementTag{number}, .type = &type, .groups = set_of(group, sets, msh)};
      for (std::size_t n = 0; n < type.nodes; ++n)
        element.nodes.push_back(NodeTag{cursor.number<std::int32_t>()});
      msh.elements.push_back(element);
    }
  }
}

}  // namespace springcheck
