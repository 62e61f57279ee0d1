#include "tests/house/arrows.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
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
  const std::string extension =
      (file.extension() == ".in" ? file.stem() : file).extension().string();
  static const std::set<std::string> all{".hpp", ".h",   ".hh",  ".hxx", ".inl", ".inc",
                                         ".ipp", ".tpp", ".cpp", ".cc",  ".cxx", ".c"};
  return all.contains(extension);
}

std::string first_folder(const std::string& place) {
  return place.substr(0, place.find('/'));
}

/// What an include directive names, by what stands behind the word; none: no file of
/// ours.
std::optional<std::string> file_of_ours(const std::string& named,
                                        const std::vector<Room>& rooms) {
  static const std::regex quoted(R"re("([^"]+)".*)re"), bracketed("<([^>]+)>.*");
  std::smatch found;
  if (std::regex_match(named, found, bracketed)) {
    const std::string file = found[1], top = first_folder(file);
    const bool is_ours = file != top && std::ranges::any_of(rooms, [&](const Room& room) {
                           return first_folder(room.folder) == top;
                         });
    if (!is_ours) return std::nullopt;
  } else if (!std::regex_match(named, found, quoted)) {
    return named;
  }
  return fs::path(found[1].str()).lexically_normal().generic_string();
}

[[noreturn]] void refuse(int line, const std::string& expected, const std::string& got) {
  throw std::runtime_error("docs/rooms.txt:" + std::to_string(line) + ": expected " +
                           expected + ", got '" + got + "'");
}

}  // namespace

std::vector<Room> read_rooms(const std::string& text) {
  std::vector<Room> rooms;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) refuse(number, "FOLDER: FOLDER...", line);
    Room room{.folder = line.substr(0, colon), .sees = {}};
    if (std::ranges::find(rooms, room.folder, &Room::folder) != rooms.end())
      refuse(number, "each room once", room.folder);
    std::istringstream names(line.substr(colon + 1));
    for (std::string name; names >> name;) {
      if (std::ranges::find(room.sees, name) != room.sees.end())
        refuse(number, "each folder once", name);
      room.sees.push_back(name);
    }
    rooms.push_back(std::move(room));
  }
  return rooms;
}

Sources sources_below(const fs::path& root, const std::vector<Room>& rooms) {
  static const std::regex directive(R"re(\s*#\s*include(?:_next)?\s*(.+))re");
  Sources sources;
  for (auto entry = fs::recursive_directory_iterator(root);
       entry != fs::recursive_directory_iterator(); ++entry) {
    const std::string place = entry->path().lexically_relative(root).generic_string();
    if (place == "build" || place == "results" || place == ".git" ||
        place == "examples" || fs::exists(entry->path() / "CMakeCache.txt"))
      entry.disable_recursion_pending();
    if (!entry->is_regular_file() || !is_source(entry->path())) continue;
    sources.files.push_back(place);
    std::ifstream file(entry->path());
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      std::smatch found;
      if (!std::regex_match(line, found, directive)) continue;
      if (const auto included = file_of_ours(found[1], rooms))
        sources.includes.push_back(
            {.file = place, .line = number, .included = *included});
    }
  }
  std::ranges::sort(sources.files);
  std::ranges::sort(sources.includes, {}, [](const Include& include) {
    return std::pair(include.file, include.line);
  });
  return sources;
}

std::vector<std::string> faults(const std::vector<Room>& rooms, const Sources& sources) {
  std::vector<std::string> found;
  const auto room_of = [&](const std::string& folder) {
    return std::ranges::find_if(
        rooms, [&](const Room& room) { return covers(room.folder, folder); });
  };
  for (auto room = rooms.begin(); room != rooms.end(); ++room)
    for (const std::string& seen : room->sees) {
      const bool stands_above =
          std::any_of(rooms.begin(), room,
                      [&](const Room& above) {
                        return covers(seen, above.folder) || covers(above.folder, seen);
                      }) &&
          std::none_of(room, rooms.end(),
                       [&](const Room& below) { return covers(seen, below.folder); });
      if (!stands_above)
        found.push_back(room->folder + " sees " + seen +
                        ", which does not stand above it");
    }
  std::set<std::pair<std::string, std::string>> used;  // room, entry
  for (const std::string& file : sources.files) {
    const auto room = room_of(folder_of(file));
    if (room == rooms.end())
      found.push_back(file + ": the list has no line for " + folder_of(file));
    else
      used.emplace(room->folder, "");
  }
  for (const Include& include : sources.includes) {
    const std::string from = folder_of(include.file), to = folder_of(include.included);
    const std::string place = include.file + ":" + std::to_string(include.line);
    const auto room = room_of(from);
    if (room == rooms.end() || covers(room->folder, to)) continue;
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
      found.push_back("there is no file in " + room.folder);
    for (const std::string& seen : room.sees)
      if (!used.contains({room.folder, seen}))
        found.push_back("no file of " + room.folder + " includes anything of " + seen);
  }
  return found;
}
