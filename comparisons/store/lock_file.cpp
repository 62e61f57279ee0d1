#include "comparisons/store/lock_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

std::string message_of(int error) {
  return std::generic_category().message(error);
}

/// Whether the file is still the one that was opened: its last holder may have removed it
/// in between.
bool is_current(int descriptor, const std::filesystem::path& file) {
  struct stat opened {};
  struct stat present {};
  return fstat(descriptor, &opened) == 0 && stat(file.c_str(), &present) == 0 &&
         opened.st_ino == present.st_ino && opened.st_dev == present.st_dev;
}

}  // namespace

LockFile::LockFile(const std::filesystem::path& file)
    : lock_(file.string() + ".lock"), descriptor_(-1) {
  while (true) {
    descriptor_ = open(lock_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0)
      throw InputError(lock_.string(), "", "a file that can be written",
                       message_of(errno));
    if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) {
      if (is_current(descriptor_, lock_)) break;
      close(descriptor_);
      continue;
    }
    const int error = errno;
    close(descriptor_);
    if (error != EWOULDBLOCK)
      throw std::runtime_error(lock_.string() +
                               ": cannot be locked: " + message_of(error));
    std::string holder;
    std::ifstream(lock_) >> holder;
    throw InputError(
        file.string(), "", "a file that no other process writes",
        "one that process " + (holder.empty() ? "unknown" : holder) + " is writing");
  }
  const std::string id = std::to_string(getpid()) + "\n";
  if (ftruncate(descriptor_, 0) != 0 ||
      pwrite(descriptor_, id.data(), id.size(), 0) != static_cast<ssize_t>(id.size())) {
    const int error = errno;
    close(descriptor_);
    throw std::runtime_error(lock_.string() + ": " + message_of(error));
  }
  removal_.emplace(lock_);
}

LockFile::~LockFile() {
  removal_.reset();
  std::error_code ignored;
  std::filesystem::remove(lock_, ignored);
  close(descriptor_);
}

}  // namespace springcheck
