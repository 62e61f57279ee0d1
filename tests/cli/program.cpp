#include "tests/cli/program.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace {

struct RemoveFolder {
  ~RemoveFolder() { fs::remove_all(folder); }
};
BOOST_TEST_GLOBAL_FIXTURE(RemoveFolder);

}  // namespace

const fs::path folder = [] {
  std::string name = (fs::temp_directory_path() / "springcheck_cli_XXXXXX").string();
  return fs::path(mkdtemp(name.data()));
}();

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

Run springcheck(const std::string& arguments, const std::string& before) {
  // A redirection in the arguments comes after ours and wins.
  const std::string command = "cd " + folder.string() + " && ( " + before +
                              std::getenv("SPRINGCHECK") + " >out 2>err </dev/null " +
                              arguments + " )";
  const int status = std::system(command.c_str());
  return {WEXITSTATUS(status), text_of(folder / "out"), text_of(folder / "err")};
}

Json json_of(const std::string& arguments) {
  return Json::parse(springcheck(arguments).out);
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

void expect_bad_input(const std::string& arguments, const std::string& part_of_message) {
  const Run run = springcheck(arguments);
  BOOST_TEST(run.status == 2, arguments);
  BOOST_TEST(run.out.empty(), run.out);
  BOOST_TEST(run.err.find(part_of_message) != std::string::npos, run.err);
}
