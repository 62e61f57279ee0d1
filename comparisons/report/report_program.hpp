#pragma once

#include <filesystem>

namespace springcheck {

/// The right to make a report in a folder, where a second one would mix its files with
/// the first one's: of this program and of the report's that it starts, which goes on
/// where this one is killed.
class FolderLock {
 public:
  /// Throws InputError where another has it.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

/// Throws InputError where there is no Python.
void check_python();

/// Runs the Python program of reports/, which this program contains: it makes page,
/// figures and 3D files of a result file and of the tables and data in the folder.
/// Returns its exit status, see run_program.
int run_report_program(const std::filesystem::path& file,
                       const std::filesystem::path& folder);

}  // namespace springcheck
