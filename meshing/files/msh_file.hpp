#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "meshing/mesh.hpp"

namespace springcheck {

/// A number that the file gives its nodes, or its elements: not negative, with gaps.
enum class NodeTag : std::int64_t {};
enum class ElementTag : std::int64_t {};

/// A kind of element of first order.
struct MshType {
  int number;  // gmsh's
  int dimension;
  std::size_t nodes;
  std::string_view name;
};

/// The type with gmsh's number, or none for those that are not of first order.
const MshType* msh_type(std::int64_t number);

/// gmsh's number of a cell's type, and of a face's with so many nodes.
int msh_number(CellType type);
int msh_number_of_face(std::size_t nodes);

struct MshNode {
  NodeTag tag;
  Vector3 position;  // in the file's unit
};

struct MshElement {
  ElementTag tag;
  const MshType* type;
  ShortList<NodeTag, 8> nodes{};  // in gmsh's order, which is ours
  std::size_t groups;             // index in MshFile::groups
};

/// What a .msh file says, with its own numbers; not checked to make sense.
struct MshFile {
  std::vector<MshNode> nodes{};
  std::vector<MshElement> elements{};
  // Sets of physical groups that elements belong to, by their positive numbers:
  std::vector<std::vector<std::int64_t>> groups;
  // The names of physical groups, by their dimension and number:
  std::map<std::pair<std::int64_t, std::int64_t>, std::string> names{};
};

/// Parses a .msh file, version 2.2 or 4.1, ASCII or binary. Nothing in it can make it
/// take more than memory and time in proportion to the file's size. We do it ourselves:
/// of 6000 damaged files gmsh 4.8.4 crashed on 40, hung on 4 and silently read nothing
/// from 438, and it runs what looks like a script of its own.
///
/// Throws InputError where the file is not of these formats, has an element of higher
/// order, or ends early.
MshFile parse_msh(const std::filesystem::path& file);

}  // namespace springcheck
