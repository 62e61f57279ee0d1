#pragma once

#include <map>

#include "meshing/files/msh_cursor.hpp"
#include "meshing/files/msh_file.hpp"

namespace springcheck {

// The sections of .msh files whose formats differ between versions 2.2 and 4.1: each
// function reads one from behind its first line up to its last one.
// Source: the formats' descriptions in the gmsh reference manual.

/// Index in MshFile::groups by dimension and number of the geometric entity.
using EntityGroups = std::map<std::pair<std::int64_t, std::int64_t>, std::size_t>;

void read_nodes_2(MshCursor& cursor, MshFile& msh);
void read_elements_2(MshCursor& cursor, MshFile& msh);

EntityGroups read_entities_4(MshCursor& cursor, MshFile& msh);
void read_nodes_4(MshCursor& cursor, MshFile& msh);
void read_elements_4(MshCursor& cursor, const EntityGroups& entities, MshFile& msh);

/// The section's last line, $End and its name.
void expect_end(MshCursor& cursor, const std::string& section);

/// The number of a physical group, without the sign that tells which way round a surface
/// is meant.
std::int64_t group_number(MshCursor& cursor, std::int64_t signed_number);

/// Throws for types that are not of first order.
const MshType& known_type(MshCursor& cursor, std::int64_t number);

}  // namespace springcheck
