#include "comparisons/command_line/parsing.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string_view>

#include "comparisons/names/suggestion.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/basics/text.hpp"

namespace springcheck {
namespace {

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

void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw std::runtime_error("standard output could not be written whole");
}

}  // namespace

Words words_of(int argc, char** argv) {
  Words words(argv + std::min(1, argc), argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (!is_utf8(words[i]))
      throw InputError("springcheck", fmt::format("argument {}", i + 1), "text in UTF-8",
                       fmt::format("other bytes: {}", quotation(words[i])));
  return words;
}

bool take_verbose(Words& words) {
  const auto is_verbose = [](const std::string& word) { return word == "--verbose"; };
  const auto first = std::ranges::find_if_not(words, is_verbose);
  const bool taken = first != words.begin();
  words.erase(words.begin(), first);
  return taken;
}

std::optional<ExitStatus> read_options(DeclaredCommand& command, Words words) {
  check_options(command.parser, words);
  std::ranges::reverse(words);  // as CLI11 takes them
  try {
    command.parser.parse(std::move(words));
  } catch (const CLI::CallForVersion&) {
    fmt::print("{}\n", version_text());
    return ExitStatus::done;
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "springcheck {0}: {1} (see springcheck help {0})\n",
               command.parser.get_name(), error.what());
    return ExitStatus::bad_input;
  }
  return std::nullopt;
}

int exit_status_of(const std::function<ExitStatus()>& program) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error like others
  try {
    const ExitStatus status = program();
    flush_output();
    return status;
  } catch (const InputError& error) {
    std::string line = error.what();  // what users wrote may hold line ends
    std::ranges::replace_if(
        line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    fmt::print(stderr, "{}\n", line);
    return ExitStatus::bad_input;
  } catch (const std::exception& error) {
    fmt::print(stderr, "springcheck: {}\n", error.what());
    return ExitStatus::fell_short;
  }
}

}  // namespace springcheck
