#include "tests/house/arrows.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

namespace fs = std::filesystem;

namespace {

constexpr std::string_view all_below = "/**";

std::string folder_of(const std::string& file) {
  return fs::path(file).parent_path().generic_string();
}

bool covers(const std::string& pattern, const std::string& folder) {
  if (!pattern.ends_with(all_below)) return pattern == folder;
  const std::string top = pattern.substr(0, pattern.size() - all_below.size());
  return folder == top || folder.starts_with(top + "/");
}

bool is_source(const fs::path& file) {
  const std::string name = file.filename().string();
  return std::ranges::any_of(std::array{".hpp", ".cpp", ".hpp.in", ".cpp.in"},
                             [&](const char* ending) { return name.ends_with(ending); });
}

}  // namespace

std::vector<Room> read_rooms(const std::string& text) {
  std::vector<Room> rooms;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    const std::size_t colon = line.find(':');
    rooms.push_back({.folder = line.substr(0, colon), .sees = {}});
    std::istringstream names(colon == std::string::npos ? "" : line.substr(colon + 1));
    for (std::string name; names >> name;) rooms.back().sees.push_back(name);
  }
  return rooms;
}

std::vector<Include> includes_below(const fs::path& root) {
  static const std::regex include_line(R"re(\s*#\s*include\s*"([^"]+)".*)re");
  std::vector<Include> includes;
  for (auto entry = fs::recursive_directory_iterator(root);
       entry != fs::recursive_directory_iterator(); ++entry) {
    const std::string place = entry->path().lexically_relative(root).generic_string();
    if (place == "build" || place == "results" || place == ".git")
      entry.disable_recursion_pending();
    if (!entry->is_regular_file() || !is_source(entry->path())) continue;
    std::ifstream file(entry->path());
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      std::smatch found;
      if (std::regex_match(line, found, include_line))
        includes.push_back({.file = place, .line = number, .included = found[1]});
    }
  }
  std::ranges::sort(includes, {}, [](const Include& include) {
    return std::pair(include.file, include.line);
  });
  return includes;
}

std::vector<std::string> faults(const std::vector<Room>& rooms,
                                const std::vector<Include>& includes) {
  std::vector<std::string> found;
  const auto room_of = [&](const std::string& folder) {
    return std::ranges::find_if(
        rooms, [&](const Room& room) { return covers(room.folder, folder); });
  };
  for (auto room = rooms.begin(); room != rooms.end(); ++room)
    for (const std::string& seen : room->sees) {
      const bool stands_above = std::any_of(rooms.begin(), room, [&](const Room& above) {
        return covers(seen, above.folder) || covers(above.folder, seen) ||
               above.folder == seen;
      });
      if (!stands_above)
        found.push_back(room->folder + " sees " + seen +
                        ", which does not stand above it");
    }
  std::set<std::pair<std::string, std::string>> used;  // room, entry
  for (const Include& include : includes) {
    const std::string from = folder_of(include.file), to = folder_of(include.included);
    const std::string place = include.file + ":" + std::to_string(include.line);
    const auto room = room_of(from);
    if (room == rooms.end()) {
      found.push_back(place + ": the list has no line for " + from);
      continue;
    }
    used.emplace(room->folder, "");
    if (covers(room->folder, to)) continue;
    const auto entry = std::ranges::find_if(
        room->sees, [&](const std::string& seen) { return covers(seen, to); });
    if (entry == room->sees.end())
      found.push_back(place + ": includes " + include.included + ", but " + room->folder +
                      " may not see " + to);
    else
      used.emplace(room->folder, *entry);
  }
  for (const Room& room : rooms) {
    if (!used.contains({room.folder, ""}))
      found.push_back("no file of " + room.folder + " includes anything");
    for (const std::string& seen : room.sees)
      if (!used.contains({room.folder, seen}))
        found.push_back("no file of " + room.folder + " includes anything of " + seen);
  }
  return found;
}
