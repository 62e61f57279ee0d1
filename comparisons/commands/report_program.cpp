#include "comparisons/commands/report_program.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include "comparisons/shipped/shipped.hpp"
#include "comparisons/system/process.hpp"
#include "meshing/input_error.hpp"
#include "meshing/output_file.hpp"

namespace springcheck {
namespace {

constexpr const char* python = "/usr/bin/python3";

constexpr const char* folder_name = "springcheck-report-";
constexpr const char* lock_name = "in-use";

/// The folder's lock, which its program and the report's hold as long as they live; -1
/// where others hold it.
int locked(const std::filesystem::path& folder, int flags) {
  const int descriptor = open((folder / lock_name).c_str(), O_RDWR | flags, 0600);
  if (descriptor >= 0 && flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    close(descriptor);
    return -1;
  }
  return descriptor;
}

/// Removes the folders of those that were killed.
void remove_abandoned_folders(const std::filesystem::path& in) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(in, ignored)) {
    if (!entry.path().filename().string().starts_with(folder_name)) continue;
    const int lock = locked(entry.path(), 0);
    if (lock < 0) continue;
    std::filesystem::remove_all(entry.path(), ignored);
    close(lock);
  }
}

/// A folder that goes with this value, or with the next one where this is killed.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const std::filesystem::path in = std::filesystem::temp_directory_path();
    remove_abandoned_folders(in);
    std::string name = (in / (std::string(folder_name) + "XXXXXX")).string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error(name + ": " + std::generic_category().message(errno));
    path_ = name;
    lock_ = locked(path_, O_CREAT);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
    close(lock_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_;
};

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(open((folder / "data").c_str(), O_RDONLY)) {  // children have it too
  if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    if (descriptor_ >= 0) close(descriptor_);
    throw InputError(folder.string(), "", "a folder that no other report is made in",
                     error == EWOULDBLOCK ? "one that another is being made in"
                                          : std::generic_category().message(error));
  }
}

FolderLock::~FolderLock() {
  close(descriptor_);
}

void check_python() {
  if (access(python, X_OK) != 0)
    throw InputError(python, "", "Python 3 (sudo apt-get install python3)",
                     std::generic_category().message(errno));
}

int run_report_program(const std::filesystem::path& file,
                       const std::filesystem::path& folder) {
  const TemporaryFolder sources;
  for (const ShippedFile& source : shipped_report()) {
    const std::filesystem::path place = sources.path() / source.name;
    std::filesystem::create_directories(place.parent_path());
    write_whole_stream(place, [&](std::ostream& out) { out << source.text; });
  }
  return run_program({python, "-B", sources.path() / "springcheck_report", file, folder});
}

}  // namespace springcheck
