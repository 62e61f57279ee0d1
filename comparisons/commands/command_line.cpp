#include "comparisons/commands/command_line.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <string>

#include "comparisons/command_line/parsing.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/studies/study.hpp"
#include "comparisons/system/blas.hpp"
#include "comparisons/system/interruption.hpp"
#include "comparisons/system/terminal.hpp"
#include "meshing/basics/input_error.hpp"

namespace springcheck {
namespace {

ExitStatus run_words(Words words) {
  const bool verbose = take_verbose(words);
  if (words.empty()) throw InputError("springcheck", "", "a command", "none");
  DeclaredCommand command(command_named(words.front()));
  words.erase(words.begin());
  if (const auto ended = read_options(command, std::move(words))) return *ended;
  spdlog::set_default_logger(spdlog::stderr_color_mt(
      "springcheck",
      declines_colours() ? spdlog::color_mode::never : spdlog::color_mode::automatic));
  spdlog::set_level(verbose || command.verbose ? spdlog::level::debug
                                               : spdlog::level::warn);
  use_one_blas_thread();
  watch_interruptions();
  try {
    return command.action();
  } catch (const NoAnswer& error) {
    fmt::print(stderr, "springcheck: {}\n", error.what());
    return ExitStatus::unexpected_status;
  }
}

}  // namespace

int command_line(int argc, char** argv) {
  return exit_status_of([&] { return run_words(words_of(argc, argv)); });
}

}  // namespace springcheck
