#include "comparisons/report/report_program.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include "comparisons/shipped/shipped.hpp"
#include "comparisons/system/process.hpp"
#include "comparisons/system/temporary_folder.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/output_file.hpp"

namespace springcheck {
namespace {

constexpr const char* python = "/usr/bin/python3";

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
  const TemporaryFolder sources("report");
  for (const ShippedFile& source : shipped_report()) {
    const std::filesystem::path place = sources.path() / source.name;
    std::filesystem::create_directories(place.parent_path());
    write_whole_stream(place, [&](std::ostream& out) { out << source.text; });
  }
  return run_program({python, "-B", sources.path() / "springcheck_report", file, folder});
}

}  // namespace springcheck
