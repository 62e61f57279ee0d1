#include "meshing/basics/output_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "meshing/basics/input_error.hpp"

namespace springcheck {

std::filesystem::path link_target(const std::filesystem::path& file) {
  std::filesystem::path place = file;
  for (int links = 0; links < 40 && std::filesystem::is_symlink(place); ++links)
    place = place.parent_path() / std::filesystem::read_symlink(place);
  return place;
}

void check_writable(const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& got) {
    throw InputError(file.string(), "", "a file that can be written", got);
  };
  if (file.empty()) refuse("an empty name");
  const std::filesystem::path place = link_target(file);
  if (std::filesystem::is_directory(place)) refuse("a directory");
  if (std::filesystem::exists(place) && !std::filesystem::is_regular_file(place))
    refuse("something that is not a regular file");
  if (std::filesystem::exists(place) && access(place.c_str(), W_OK) != 0)
    refuse("a file without permission to write");
  const std::filesystem::path folder =
      place.has_parent_path() ? place.parent_path() : std::filesystem::path(".");
  std::string probe = (folder / ".springcheck-XXXXXX").string();
  const int descriptor = mkstemp(probe.data());
  if (descriptor < 0) refuse(std::generic_category().message(errno));
  close(descriptor);
  std::filesystem::remove(probe);
}

namespace {

/// Sets the permissions of the file that the unfinished one is to replace, or those that
/// new files have.
void set_permissions(const std::filesystem::path& unfinished,
                     const std::filesystem::path& place) {
  if (std::filesystem::exists(place)) {
    std::filesystem::permissions(unfinished,
                                 std::filesystem::status(place).permissions());
    return;
  }
  const mode_t hidden = umask(0);
  umask(hidden);
  chmod(unfinished.c_str(), 0666 & ~hidden);
}

}  // namespace

void write_whole(
    const std::filesystem::path& file,
    const std::function<void(const std::filesystem::path& unfinished)>& write) {
  const std::filesystem::path place = link_target(file);
  const std::string extension = place.extension().string();
  // A name that nobody has, with the extension by which formats are told.
  std::string name = place.string();
  name.resize(name.size() - extension.size());
  name += ".XXXXXX" + extension;
  const int descriptor = mkstemps(name.data(), static_cast<int>(extension.size()));
  if (descriptor < 0)
    throw std::runtime_error(file.string() + ": " +
                             std::generic_category().message(errno));
  close(descriptor);
  const std::filesystem::path unfinished = name;
  try {
    set_permissions(unfinished, place);
    write(unfinished);
    std::filesystem::rename(unfinished, place);
  } catch (...) {
    std::error_code ignored;  // the first failure is the one to report
    std::filesystem::remove(unfinished, ignored);
    throw;
  }
}

void write_whole_stream(const std::filesystem::path& file,
                        const std::function<void(std::ostream&)>& write) {
  write_whole(file, [&](const std::filesystem::path& unfinished) {
    std::ofstream out(unfinished, std::ios::binary);
    write(out);
    out.close();
    if (!out)
      throw std::runtime_error(file.string() +
                               ": could not be written whole (disk full?)");
  });
}

}  // namespace springcheck
