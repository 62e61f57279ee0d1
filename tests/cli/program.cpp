#include "tests/cli/program.hpp"

#include <sys/wait.h>
#include <unistd.h>
#include <wordexp.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

#include "comparisons/commands/command_line.hpp"
#include "comparisons/commands/commands.hpp"
#include "comparisons/front/front.hpp"
#include "comparisons/system/blas.hpp"
#include "tests/json_schema.hpp"

namespace {

/// The words as pointers, in the form in which main takes them.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Chooses a fitting BLAS as the program does, which would start again with a test's
/// arguments.
void use_fitting_blas() {
  std::ifstream file("/proc/self/cmdline");
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
  std::vector<char*> arguments = pointers_to(words);
  if (std::getenv("OPENBLAS_CORETYPE") != nullptr) return;
  springcheck::choose_fitting_blas();
  if (std::getenv("OPENBLAS_CORETYPE") != nullptr)
    execv("/proc/self/exe", arguments.data());
}

const springcheck::OwnFolder& own_folder() {
  use_fitting_blas();
  static const springcheck::OwnFolder folder;
  return folder;
}

}  // namespace

const fs::path folder = own_folder().path;

namespace {

/// The words of the arguments as a shell would split them; empty where only a shell can,
/// and for names of files in a folder that this process is not in yet.
std::vector<std::string> split(const std::string& arguments) {
  wordexp_t words;
  if (arguments.find_first_of("*?[$") != std::string::npos ||
      wordexp(arguments.c_str(), &words, WRDE_NOCMD) != 0)
    return {};
  std::vector<std::string> all(words.we_wordv, words.we_wordv + words.we_wordc);
  wordfree(&words);
  return all;
}

/// noexcept: nothing is to go on with the tests, nor are Boost.Test's signal handlers.
[[noreturn]] void run_here(std::vector<std::string> words) noexcept {
  for (const int number : {SIGABRT, SIGALRM, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGSYS})
    std::signal(number, SIG_DFL);
  std::vector<char*> arguments = pointers_to(words);
  int status = 1;
  if (chdir(folder.c_str()) == 0 && std::freopen("/dev/null", "r", stdin) != nullptr &&
      std::freopen("out", "w", stdout) != nullptr &&
      std::freopen("err", "w", stderr) != nullptr)
    status = springcheck::front(static_cast<int>(words.size()), arguments.data(),
                                text_of(springcheck::declarations()),
                                springcheck::command_line);
  std::cout.flush();
  std::fflush(nullptr);
  _exit(status);  // without the end of the tests
}

/// JSON that a command prints must be what its schema says.
void check_json(const std::string& arguments, const std::string& out) {
  static const Json schema = Json::parse(run_springcheck("schema result").out);
  BOOST_TEST(violations(schema, Json::parse(out)) == "", arguments);
}

}  // namespace

Run run_springcheck(const std::string& arguments, const std::string& before) {
  const std::string program = std::getenv("SPRINGCHECK");
  std::vector<std::string> words = split(arguments);
  int status = 0;
  if (before.empty() && !words.empty()) {
    words.insert(words.begin(), program);
    std::fflush(nullptr);
    const pid_t child = fork();
    BOOST_TEST_REQUIRE(child >= 0);
    if (child == 0) run_here(std::move(words));
    BOOST_TEST_REQUIRE(waitpid(child, &status, 0) == child);
  } else {
    // A redirection in the arguments comes after ours and wins.
    const std::string command = "cd " + folder.string() + " && ( " + before + program +
                                " >out 2>err </dev/null " + arguments + " )";
    status = std::system(command.c_str());
  }
  Run run{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          text_of(folder / "out"), text_of(folder / "err")};
  const bool is_json = arguments.find(" --json") != std::string::npos ||
                       arguments.find(" --format json") != std::string::npos;
  if (is_json && run.out.starts_with('{')) check_json(arguments, run.out);
  return run;
}

Json json_of(const std::string& arguments) {
  return Json::parse(run_springcheck(arguments).out);
}

Json result_of(const std::string& arguments) {
  return json_of(arguments)["results"][0];
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

void expect_bad_input(const std::string& arguments, const std::string& part_of_message) {
  const Run run = run_springcheck(arguments);
  BOOST_TEST(run.status == 2, arguments);
  BOOST_TEST(run.out.empty(), run.out);
  BOOST_TEST(run.err.find(part_of_message) != std::string::npos, run.err);
}
