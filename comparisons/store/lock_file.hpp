#pragma once

#include <filesystem>
#include <optional>

#include "comparisons/system/interruption.hpp"

namespace springcheck {

/// The right to write a file, held by one process at a time: FILE.lock, which holds the
/// process's id and goes with it, however it ends.
class LockFile {
 public:
  /// Throws InputError with the holder's process id when another process (or this one)
  /// has the right.
  explicit LockFile(const std::filesystem::path& file);
  ~LockFile();
  LockFile(const LockFile&) = delete;
  LockFile& operator=(const LockFile&) = delete;

 private:
  std::filesystem::path lock_;
  int descriptor_;
  std::optional<RemovedAtInterruption> removal_{};
};

}  // namespace springcheck
