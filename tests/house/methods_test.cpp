// Outside comparisons/methods nobody asks of what kind a method is: an entry says what it
// can do.

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

BOOST_AUTO_TEST_SUITE(methods_test)

namespace {

namespace fs = std::filesystem;

/// What asks for a kind: a question of a method, its name beside a literal one, what a
/// variant holds of it, the beginning of a name.
const std::vector<std::regex>& questions() {
  static const std::vector<std::regex> all{
      std::regex(R"(\bis_\w+\([\w.>()-]*method\b[\w.()]*\))"),
      std::regex(R"([=!]=\s*(std::string(_view)?[({])?"(mss|fem)-)"),
      std::regex(R"("(mss|fem)-[\w-]*"[)}]?\s*[=!]=)"),
      std::regex(R"((get_if|holds_alternative|std::get)<[^>]*>\(&?[\w.]*method)"),
      std::regex(R"(starts_with\("(mss|fem))"),
      std::regex(R"(startswith\(\(?"(mss|fem)-?")")};
  return all;
}

/// Places that may call methods by their names, which are data there.
bool may_name_methods(const std::string& file) {
  static const std::vector<std::string> all{
      "comparisons/bench.cpp",                          // what it times
      "comparisons/commands/output/result_json.cpp",    // an example of a result
      "comparisons/modes/body_modes.cpp",               // whose modes the table has
      "comparisons/settings/setting_table.cpp",         // a default
      "comparisons/tables/",                            // what the studies run
      "reports/springcheck_report/sections/bodies.py",  // columns of a figure
      "reports/springcheck_report/sections/laws.py",    // labels of a table's columns
      "reports/springcheck_report/sections/speed.py",   // figures of the thesis
      "reports/springcheck_results.py"};                // an example
  return std::ranges::any_of(
      all, [&](const std::string& one) { return file.starts_with(one); });
}

/// Whole names of methods, which constants, lists and sets may hide from the questions.
const std::regex& name_of_method() {
  static const std::regex name(R"(["'](mss|fem)(-[a-z0-9:,-]*)?["'])");
  return name;
}

std::vector<std::string> faults_in(const std::string& name, std::istream& text) {
  std::vector<std::string> faults;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (!name.ends_with(".py")) line = line.substr(0, line.find("//"));
    const bool asks = std::ranges::any_of(questions(), [&](const std::regex& question) {
      return std::regex_search(line, question);
    });
    if (asks || (!may_name_methods(name) && std::regex_search(line, name_of_method())))
      faults.push_back(name + ":" + std::to_string(number) + ": " + line);
  }
  return faults;
}

std::size_t faults_in(const std::string& line) {
  std::istringstream text(line);
  return faults_in("a file", text).size();
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_file_asks_of_what_kind_a_method_is) {
  std::size_t files = 0;
  for (const char* folder : {"comparisons", "reports"})
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string name = entry.path().generic_string();
      const std::string extension = entry.path().extension().string();
      if ((extension != ".cpp" && extension != ".hpp" && extension != ".py" &&
           extension != ".js") ||
          name.starts_with("comparisons/methods/"))
        continue;
      ++files;
      std::ifstream text(entry.path());
      for (const std::string& fault : faults_in(name, text)) BOOST_ERROR(fault);
    }
  BOOST_TEST(files > 300U);  // they were found
}

BOOST_AUTO_TEST_CASE(questions_are_recognised) {
  for (const char* line :
       {R"(  if (is_springs(settings.method)) return;)",
        R"(  if (name == "mss-cf") return;)", R"(  return method.name != "fem-hooke";)",
        R"(  if (method == std::string_view("mss-affine")) return;)",
        R"(  if ("fem-stvk" == law) return;)",
        R"(  std::get_if<mss::SpringModel>(&settings.method.model))",
        R"(  std::holds_alternative<Law>(method.model))",
        R"(  model.name.starts_with("mss-"))", R"(    if method.startswith("fem-"):)",
        R"(constexpr std::string_view best = "mss-cf";)",
        R"(    cases.method.isin(["mss-cf", "mss-nfd"]))", R"(_STVK = 'fem-stvk')",
        R"(    law = words if "fem" in method else "")", R"(  name.find("mss") == 0)",
        R"(    usual = ("fem-hencky:q1-sri",))"})
    BOOST_TEST(faults_in(line) > 0U, line);
  for (const char* line : {R"(  if (reads(settings.method, "element")) return;)",
                           R"(  if (settings.method.is_elastic) return;)"})
    BOOST_TEST(faults_in(line) == 0U, line);
}

BOOST_AUTO_TEST_SUITE_END()
