#include "comparisons/system/temporary_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace springcheck {
namespace {

constexpr const char* lock_name = "in-use";

/// The folder's lock, which its program and that program's children hold as long as they
/// live; -1 where others hold it.
int locked(const std::filesystem::path& folder, int flags) {
  const int descriptor = open((folder / lock_name).c_str(), O_RDWR | flags, 0600);
  if (descriptor >= 0 && flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    close(descriptor);
    return -1;
  }
  return descriptor;
}

/// Removes the folders of those that were killed.
void remove_abandoned_folders(const std::filesystem::path& in, const std::string& name) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(in, ignored)) {
    if (!entry.path().filename().string().starts_with(name)) continue;
    const int lock = locked(entry.path(), 0);
    if (lock < 0) continue;
    std::filesystem::remove_all(entry.path(), ignored);
    close(lock);
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder(const std::string& purpose) {
  const std::filesystem::path in = std::filesystem::temp_directory_path();
  const std::string start = "springcheck-" + purpose + "-";
  remove_abandoned_folders(in, start);
  std::string name = (in / (start + "XXXXXX")).string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error(name + ": " + std::generic_category().message(errno));
  path_ = name;
  lock_ = locked(path_, O_CREAT);
  removal_.emplace(path_);
}

TemporaryFolder::~TemporaryFolder() {
  removal_.reset();
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  close(lock_);
}

}  // namespace springcheck
