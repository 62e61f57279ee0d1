#include "comparisons/system/memory.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace springcheck {
namespace {

/// The number of kilobytes that Linux tells under a name, in bytes; none where it tells
/// none.
std::optional<double> bytes_in(const char* file, const char* name) {
  std::ifstream info(file);
  for (std::string line; std::getline(info, line);)
    if (line.starts_with(name)) {
      double kilobytes = 0;
      std::istringstream(line.substr(line.find(':') + 1)) >> kilobytes;
      return 1024 * kilobytes;
    }
  return std::nullopt;
}

/// The only number of a file; none where there is no such file, or a word ("max").
std::optional<double> number_in(const std::filesystem::path& file) {
  double value = 0;
  return std::ifstream(file) >> value ? std::optional(value) : std::nullopt;
}

/// The number behind its name and a blank in a file; none where there is no such name.
std::optional<double> number_in(const std::filesystem::path& file,
                                const std::string& name) {
  std::ifstream lines(file);
  for (std::string word; lines >> word;) {
    double value = 0;
    if (lines >> value && word == name) return value;
  }
  return std::nullopt;
}

/// The names of the files of a version of control groups.
struct GroupFiles {
  const char *limit, *used, *cached;
};
constexpr GroupFiles version_1{"memory.limit_in_bytes", "memory.usage_in_bytes",
                               "total_inactive_file"},
    version_2{"memory.max", "memory.current", "inactive_file"};

/// The memory that is left to the group and those above it, up to the mount. A container
/// sees its own group as the mount, whatever its path is outside.
double room_of_group(const std::filesystem::path& mount, std::filesystem::path group,
                     const GroupFiles& files) {
  double room = INFINITY;
  for (group = group.relative_path();; group = group.parent_path()) {
    const std::filesystem::path folder = mount / group;
    const auto limit = number_in(folder / files.limit),
               used = number_in(folder / files.used);
    if (limit && used)
      room =
          std::min(room, *limit - *used +
                             number_in(folder / "memory.stat", files.cached).value_or(0));
    if (group.empty()) return room;
  }
}

}  // namespace

double room_of_control_groups(const std::filesystem::path& root) {
  double room = INFINITY;
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {  // 4:memory:/path or 0::/path
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers =
        "," + line.substr(first + 1, second - first - 1) + ",";
    const std::string path = line.substr(second + 1);
    const std::filesystem::path mount = root / "sys/fs/cgroup";
    if (controllers == ",,")
      for (const auto& place : {mount, mount / "unified"})
        room = std::min(room, room_of_group(place, path, version_2));
    else if (controllers.find(",memory,") != std::string::npos)
      room = std::min(room, room_of_group(mount / "memory", path, version_1));
  }
  return std::max(room, 0.);
}

double room_of_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return INFINITY;
  return std::max(static_cast<double>(limit.rlim_cur) -
                      bytes_in("/proc/self/status", "VmSize:").value_or(0),
                  0.);
}

double available_memory() {
  return std::min({bytes_in("/proc/meminfo", "MemAvailable:").value_or(INFINITY),
                   room_of_control_groups("/"), room_of_address_space()});
}

double resident_memory() {
  return bytes_in("/proc/self/status", "VmRSS:").value_or(0);
}

double peak_memory() {
  return bytes_in("/proc/self/status", "VmHWM:").value_or(0);
}

void reset_peak_memory() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace springcheck
