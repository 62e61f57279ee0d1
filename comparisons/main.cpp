#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "comparisons/command_line/exit_status.hpp"
#include "comparisons/declarations_text.hpp"
#include "comparisons/front/front.hpp"
#include "comparisons/system/blas.hpp"

namespace {

/// Beside this program where it was built, in libexec where it is installed.
std::filesystem::path place_of_core() {
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::filesystem::path built = folder / "springcheck-core";
  return std::filesystem::exists(built)
             ? built
             : folder.parent_path() / "libexec/springcheck/springcheck-core";
}

/// Becomes the program that computes.
int start_core(int, char** arguments) {
  springcheck::choose_fitting_blas();
  const std::filesystem::path core = place_of_core();
  execv(core.c_str(), arguments);
  fmt::print(stderr, "springcheck: {}: expected the program that computes, got: {}\n",
             core.string(), std::strerror(errno));
  return springcheck::ExitStatus::fell_short;
}

}  // namespace

int main(int argc, char** argv) {
  springcheck::restart_with_one_blas_thread(argv);
  return springcheck::front(
      argc, argv, springcheck::declarations_from(springcheck::declarations_text),
      start_core);
}
