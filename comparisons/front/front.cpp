#include "comparisons/front/front.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "comparisons/command_line/parsing.hpp"
#include "comparisons/front/front_commands.hpp"
#include "comparisons/names/suggestion.hpp"

namespace springcheck {
namespace {

bool asks_for_help(const Words& words) {
  const auto end = std::ranges::find(words, "--");
  return std::any_of(words.begin(), end, [](const std::string& word) {
    return word == "--help" || word == "-h";
  });
}

ExitStatus help(std::string_view name, const Declarations& all) {
  print_help(name, all);
  return ExitStatus::done;
}

/// Nothing where the words ask for a command of the core.
std::optional<ExitStatus> run_own(Words words, const Declarations& all) {
  take_verbose(words);
  if (words.empty()) {
    print_help({}, all);
    return ExitStatus::bad_input;
  }
  const std::string word = words.front();
  if (word == "--help" || word == "-h") return help({}, all);
  if (word == "--version") {
    fmt::print("{}\n", version_text());
    return ExitStatus::done;
  }
  if (word.starts_with('-'))
    refuse_name("springcheck", "option", word, {"--help", "--version", "--verbose"});
  const CommandText& text = command_named(word, all);
  if (asks_for_help(words)) return help(text.name, all);  // whatever else is wrong
  for (const Command& command : front_commands(all))
    if (command.name == word) {
      DeclaredCommand declared(command);
      const auto ended = read_options(declared, Words(words.begin() + 1, words.end()));
      return ended ? *ended : declared.action();
    }
  return std::nullopt;
}

}  // namespace

int front(int argc, char** argv, std::string_view declarations_of_core, Core core) {
  bool is_of_core = false;
  const int status = exit_status_of([&] {
    Declarations declared = declarations_from(declarations_of_core);
    add_front_commands(declared);
    const auto ended = run_own(words_of(argc, argv), declared);
    is_of_core = !ended;
    return ended.value_or(ExitStatus::done);
  });
  return is_of_core ? core(argc, argv) : status;
}

}  // namespace springcheck
