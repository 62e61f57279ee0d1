#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "comparisons/command_line/exit_status.hpp"
#include "comparisons/declarations_text.hpp"
#include "comparisons/front/front.hpp"
#include "comparisons/system/blas.hpp"

namespace {

constexpr auto name_of_core = "springcheck-core";

/// Becomes the program that computes: the one beside this, where that was built, or in
/// libexec, where it is installed.
int start_core(int, char** arguments) {
  springcheck::choose_fitting_blas();
  std::error_code none;
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
  const std::filesystem::path places[] = {
      folder / name_of_core, folder.parent_path() / "libexec/springcheck" / name_of_core};
  for (const std::filesystem::path& place : places) execv(place.c_str(), arguments);
  fmt::print(stderr,
             "springcheck: expected the program that computes as {} or {}, got: {}\n",
             places[0].string(), places[1].string(), std::strerror(errno));
  return springcheck::ExitStatus::fell_short;
}

}  // namespace

int main(int argc, char** argv) {
  springcheck::restart_with_one_blas_thread(argv);
  return springcheck::front(argc, argv, springcheck::declarations_text, start_core);
}
