#pragma once

#include <filesystem>
#include <string>
#include <vector>

// Which folder of the repository includes which, held against docs/rooms.txt.

/// A line of the list: "mss/forces: meshing mss/networks". A folder that ends in /** is
/// that folder and all that is in it.
struct Room {
  std::string folder;
  std::vector<std::string> sees;
};

/// The list's lines in their order; '#' starts a comment, blank lines are skipped.
std::vector<Room> read_rooms(const std::string& text);

/// An #include "..." of a source file.
struct Include {
  std::string file;  // from the repository's root on: "mss/forces/forces.cpp"
  int line;
  std::string included;  // as written
};

/// Of all .hpp and .cpp files below the root, those that are configured (.in) too, but
/// for folders that git ignores: build, results.
std::vector<Include> includes_below(const std::filesystem::path& root);

/// What is wrong, a sentence each: a file that stands in no room, an include of a folder
/// that its own may not see, a room that sees one standing below it in the list (without
/// any, there is no circle of folders), an entry or a room that no include needs.
std::vector<std::string> faults(const std::vector<Room>& rooms,
                                const std::vector<Include>& includes);
