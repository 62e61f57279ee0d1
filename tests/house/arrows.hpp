#pragma once

#include <filesystem>
#include <string>
#include <vector>

// These functions hold which folder of the repository includes which against
// docs/rooms.txt.

/// A line of the list: "mss/forces: meshing mss/networks". A folder that ends in /** is
/// that folder and all that is in it.
struct Room {
  std::string folder;
  std::vector<std::string> sees;
};

/// The list's lines in their order; '#' starts a comment, blank lines are skipped. Throws
/// std::runtime_error for a line without a colon and a name that is given twice.
std::vector<Room> read_rooms(const std::string& text);

/// An #include of a file of ours: in quotes, or in angle brackets from one of our
/// folders. What a macro names is a file in no folder.
struct Include {
  std::string file;  // from the repository's root on: "mss/forces/forces.cpp"
  int line;
  std::string included;  // without "." and ".."
};

struct Sources {
  std::vector<std::string> files;
  std::vector<Include> includes;
};

/// All C++ files below the root, those that are configured (.in) too, but for folders
/// that git ignores (results, and where something is built) and the examples, which are
/// programs of others: they see what is installed.
Sources sources_below(const std::filesystem::path& root, const std::vector<Room>& rooms);

/// What is wrong, a sentence each: a file that stands in no room, an include of a folder
/// that its own may not see, a room that sees one not standing above it in the list
/// (without any, there is no circle of folders), an entry that no include needs, a room
/// without files.
std::vector<std::string> faults(const std::vector<Room>& rooms, const Sources& sources);
