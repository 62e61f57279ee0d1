#include "comparisons/commands/report_program.hpp"

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

/// A folder that goes with this value.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name =
        (std::filesystem::temp_directory_path() / "springcheck-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error(name + ": " + std::generic_category().message(errno));
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

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
