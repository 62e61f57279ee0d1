#include "comparisons/commands/command_line.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "comparisons/cases/exit_status.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/settings/suggestion.hpp"
#include "comparisons/studies/study.hpp"
#include "comparisons/system/blas.hpp"
#include "comparisons/system/interruption.hpp"
#include "meshing/input_error.hpp"
#include "meshing/text.hpp"

namespace springcheck {
namespace {

using Words = std::vector<std::string>;

/// All of them may come to stand in JSON and HDF5.
void check_utf8(const Words& words) {
  for (std::size_t i = 0; i < words.size(); ++i)
    if (!is_utf8(words[i]))
      throw InputError("springcheck", fmt::format("argument {}", i + 1), "text in UTF-8",
                       fmt::format("other bytes: {}", quotation(words[i])));
}

/// Refuses an option that the command does not have: CLI11 would name its value, too.
void check_options(const CLI::App& parser, const Words& words) {
  Words options;
  for (const CLI::Option* option : parser.get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  const std::vector<std::string_view> names(options.begin(), options.end());
  for (const std::string& word : words) {
    if (word == "--") return;
    if (!word.starts_with("--")) continue;
    const std::string name = word.substr(0, word.find('='));
    if (std::ranges::count(names, name) > 0) continue;
    const std::string_view meant = nearest(name, names);
    throw InputError(fmt::format(
        "springcheck {0}: unknown option '{1}'{2} (springcheck help {0} tells all)",
        parser.get_name(), clipped(name),
        meant.empty() ? "" : fmt::format(", did you mean '{}'?", meant)));
  }
}

bool asks_for_help(const Words& words) {
  const auto end = std::ranges::find(words, "--");
  return std::any_of(words.begin(), end, [](const std::string& word) {
    return word == "--help" || word == "-h";
  });
}

/// What was printed must have arrived: a full disk or a closed pipe is a failure.
void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw std::runtime_error("standard output could not be written whole");
}

ExitStatus run_command_with(const Command& command, Words words, bool verbose,
                            char** argv) {
  if (asks_for_help(words)) {  // whatever else is wrong
    print_help(command.name);
    return ExitStatus::done;
  }
  DeclaredCommand declared(command);
  check_options(declared.parser, words);
  std::ranges::reverse(words);  // as CLI11 takes them
  try {
    declared.parser.parse(std::move(words));
  } catch (const CLI::CallForVersion&) {
    fmt::print("{}\n", version_text());
    return ExitStatus::done;
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "springcheck {0}: {1} (see springcheck help {0})\n", command.name,
               error.what());
    return ExitStatus::bad_input;
  }
  spdlog::set_default_logger(spdlog::stderr_color_mt("springcheck"));
  spdlog::set_level(verbose || declared.verbose ? spdlog::level::debug
                                                : spdlog::level::warn);
  if (command.simulates) restart_with_fitting_blas(argv);
  use_one_blas_thread();
  watch_interruptions();
  return declared.action();
}

/// What the words ask for, the first of which may be --verbose.
ExitStatus run_words(Words words, char** argv) {
  const auto is_verbose = [](const std::string& word) { return word == "--verbose"; };
  const auto first = std::ranges::find_if_not(words, is_verbose);
  const bool verbose = first != words.begin();
  words.erase(words.begin(), first);
  if (words.empty()) {
    print_help({});
    return ExitStatus::bad_input;
  }
  const std::string& word = words.front();
  if (word == "--help" || word == "-h") {
    print_help({});
    return ExitStatus::done;
  }
  if (word == "--version") {
    fmt::print("{}\n", version_text());
    return ExitStatus::done;
  }
  if (word.starts_with('-'))
    refuse_name("springcheck", "option", word, {"--help", "--version", "--verbose"});
  const Command command = command_named(word);
  return run_command_with(command, Words(words.begin() + 1, words.end()), verbose, argv);
}

int run_arguments(int argc, char** argv) {
  restart_with_one_blas_thread(argv);
  const Words words(argv + std::min(1, argc), argv + argc);
  check_utf8(words);
  const ExitStatus status = run_words(words, argv);
  flush_output();
  return status;
}

}  // namespace

int command_line(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error like others
  try {
    return run_arguments(argc, argv);
  } catch (const InputError& error) {
    std::string line = error.what();  // what users wrote may hold line ends
    std::ranges::replace_if(
        line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    fmt::print(stderr, "{}\n", line);
    return ExitStatus::bad_input;
  } catch (const NoAnswer& error) {
    fmt::print(stderr, "springcheck: {}\n", error.what());
    return ExitStatus::unexpected_status;
  } catch (const std::exception& error) {
    fmt::print(stderr, "springcheck: {}\n", error.what());
    return ExitStatus::fell_short;
  }
}

}  // namespace springcheck
