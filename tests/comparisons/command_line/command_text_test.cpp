#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <set>
#include <sstream>

#include "comparisons/command_line/completion.hpp"
#include "comparisons/command_line/help_text.hpp"
#include "comparisons/command_line/manual_page.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/front/front_commands.hpp"
#include "comparisons/settings/setting.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(command_text_test)

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

const Declarations& all() {
  static const Declarations told = [] {
    Declarations declared = declarations();
    add_front_commands(declared);
    return declared;
  }();
  return told;
}

std::vector<Command> all_commands() {
  std::vector<Command> commands = front_commands(all());
  for (const auto& make : every_command) commands.push_back(make());
  return commands;
}

/// The words of the first program of an example: "springcheck run compression | less".
std::vector<std::string> words_of(std::string_view example) {
  std::istringstream in{std::string(example.substr(0, example.find(" | ")))};
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// Whether a line is too long though it could be broken.
bool is_too_long(const std::string& line, std::size_t width) {
  const std::size_t text = line.find_first_not_of(' ');
  return line.size() > width && line.find(' ', text) != line.npos;
}

std::string without_backslashes(std::string text) {
  std::erase(text, '\\');
  return text;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_examples_of_every_command_are_understood) {
  for (const Command& command : all_commands()) {
    BOOST_TEST(!command.examples.empty(), command.name);
    for (const Example& example : command.examples) {
      std::vector<std::string> words = words_of(example.words);
      if (words.front() == "eval") continue;  // of a shell
      BOOST_TEST_REQUIRE(words.size() >= 2U, example.words);
      BOOST_TEST(words[0] == "springcheck", example.words);
      BOOST_TEST(words[1] == command.name, example.words);
      DeclaredCommand declared(command);
      std::vector<std::string> rest(words.begin() + 2, words.end());
      std::ranges::reverse(rest);
      BOOST_CHECK_NO_THROW(declared.parser.parse(std::move(rest)));
    }
  }
}

BOOST_AUTO_TEST_CASE(help_stays_within_narrow_terminals) {
  for (const std::size_t width : {40U, 60U, 100U}) {
    for (const CommandText& text : all().commands)
      for (const std::string& line : lines_of(help_text(text, width)))
        BOOST_TEST(!is_too_long(line, width), text.name << ": " << line);
    for (const std::string& line : lines_of(overview_text(all().commands, width)))
      BOOST_TEST(!is_too_long(line, width), line);
  }
  // A screen has 30 lines or so.
  BOOST_TEST(lines_of(overview_text(all().commands, 80)).size() <= 30U);
}

BOOST_AUTO_TEST_CASE(help_has_groups_defaults_and_what_is_needed) {
  const std::string help = help_text(command_named("run", all()), 80);
  std::vector<std::size_t> places;
  for (const char* heading :
       {"\nExamples:\n", "\nMethod:\n", "\nScene:\n", "\nMaterial:\n", "\nSolver:\n",
        "\nDynamics:\n", "\nTissue:\n", "\nOutput:\n", "\nOptions:\n"})
    places.push_back(help.find(heading));
  BOOST_TEST(std::ranges::is_sorted(places));
  BOOST_TEST(places.back() != help.npos);
  BOOST_TEST(help.starts_with("Usage: springcheck run SCENE [OPTIONS]\n"));
  BOOST_TEST(help.find("--fail-on") != help.npos);
  const std::string chart = help_text(command_named("chart", all()), 80);
  BOOST_TEST(chart.find("(default 4,6,10,16)") != chart.npos);
  BOOST_TEST(chart.find("HDF5 file to add the chart to (needed)") != chart.npos);
  BOOST_TEST(chart.find("INT in") == chart.npos);  // CLI11's word for a range
  const std::string merge = help_text(command_named("merge", all()), 80);
  BOOST_TEST(merge.starts_with("Usage: springcheck merge OUT FROM... [OPTIONS]\n"));
}

BOOST_AUTO_TEST_CASE(every_option_stands_in_help_manual_and_completion) {
  const std::vector<CommandText>& texts = all().commands;
  for (const CommandText& text : texts) {
    const std::string help = help_text(text, 80),
                      page = without_backslashes(manual_page(text));
    for (const OptionText& option : text.options)
      for (const std::string& name : option.names) {
        BOOST_TEST(help.find(name) != help.npos, text.name << name);
        BOOST_TEST(page.find(name) != page.npos, text.name << name);
      }
  }
  const std::string bash = completion_script(Shell::bash, texts),
                    zsh = completion_script(Shell::zsh, texts),
                    fish = completion_script(Shell::fish, texts);
  for (const std::string_view key : option_keys()) {
    const std::string name(key);
    BOOST_TEST(bash.find("--" + name) != bash.npos, name);
    BOOST_TEST(zsh.find("'--" + name) != zsh.npos, name);
    BOOST_TEST(fish.find(" -l " + name + " ") != fish.npos, name);
  }
}

BOOST_AUTO_TEST_CASE(no_line_of_a_manual_page_is_an_unknown_macro) {
  std::set<std::string> macros;
  for (const CommandText& text : all().commands)
    for (const std::string& line : lines_of(manual_page(text)))
      if (line.starts_with('.')) macros.insert(line.substr(0, line.find(' ')));
  const std::set<std::string> known{".TH", ".SH", ".SS", ".TP", ".B", ".BR", ".PP"};
  BOOST_CHECK_EQUAL_COLLECTIONS(macros.begin(), macros.end(), known.begin(), known.end());
}

// A type in capitals is a list that completion knows, or nothing has names for it.
BOOST_AUTO_TEST_CASE(types_in_capitals_are_known) {
  const std::set<std::string> free{"NUMBER",  "NUMBERS",    "COUNT",    "COUNTS",
                                   "SECONDS", "KEY=VALUES", "FRACTION", "NAME",
                                   "FILE",    "FOLDER",     "I/N",      "CUT"};
  for (const CommandText& text : all().commands)
    for (const OptionText& option : text.options)
      BOOST_TEST(
          (option.type.empty() || free.contains(option.type) || !option.words.empty()),
          text.name << " " << option.names.back() << " " << option.type);
  const auto words_of_option = [](const char* command, const std::string& name) {
    for (const OptionText& option : command_named(command, all()).options)
      if (option.names.back() == name) return option.words;
    return std::vector<std::string>();
  };
  BOOST_TEST(std::ranges::count(words_of_option("run", "SCENE"), "compression") == 1);
  BOOST_TEST(std::ranges::count(words_of_option("run", "--cell-type"), "prism") == 1);
  BOOST_TEST(std::ranges::count(words_of_option("help", "COMMAND"), "manual") == 1);
  BOOST_TEST(words_of_option("manual", "--out").empty());
  BOOST_TEST(takes_files("SCENE|FILE"));
  BOOST_TEST(!takes_files("SCENE"));
}

// The program that users start knows what the other one declares from its text alone.
BOOST_AUTO_TEST_CASE(declarations_survive_their_text) {
  const Declarations told = declarations(), read = declarations_from(text_of(told));
  BOOST_TEST(read.lists.dump() == told.lists.dump());  // the order, too
  BOOST_TEST_REQUIRE(read.commands.size() == told.commands.size());
  for (std::size_t i = 0; i < read.commands.size(); ++i) {
    BOOST_TEST(help_text(read.commands[i], 80) == help_text(told.commands[i], 80));
    BOOST_TEST(json_of(read.commands[i]).dump() == json_of(told.commands[i]).dump());
  }
}

BOOST_AUTO_TEST_SUITE_END()
