#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "comparisons/system/interruption.hpp"

namespace springcheck {

/// A folder that goes with this value, or where the program is killed with the next one
/// of the same purpose: springcheck-PURPOSE-XXXXXX among the temporary files.
class TemporaryFolder {
 public:
  /// Throws std::runtime_error where none can be made.
  explicit TemporaryFolder(const std::string& purpose);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_;
  std::optional<RemovedAtInterruption> removal_{};
};

}  // namespace springcheck
