// What a case's key and its JSON are made of stays: a change would compute anew, or worse
// give back, what result files of this version hold.

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/chart/chart_models.hpp"
#include "comparisons/running/case_result.hpp"
#include "comparisons/settings/case_json.hpp"
#include "comparisons/settings/scene_file.hpp"
#include "comparisons/shipped/shipped.hpp"
#include "comparisons/sweeps/sweep_file.hpp"
#include "comparisons/tables/catalogue.hpp"
#include "meshing/basics/sha256.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(golden_settings_test)

namespace {

constexpr const char* golden = "tests/comparisons/tables/golden_settings.txt";

/// All that enters a case's key but the mesh and the version.
std::string text_of(const Request& request) {
  nlohmann::json all{{"settings", settings_json(request.settings)}};
  if (request.reference) all["reference"] = settings_json(*request.reference);
  if (request.reference_grid == ReferenceGrid::converged)
    all["reference-grid"] = "converged";
  return all.dump();
}

/// One line for many: how many, and the SHA-256 of their texts.
std::string together(const std::string& what, const std::vector<Request>& requests) {
  std::string texts;
  for (const Request& request : requests) texts += text_of(request) + "\n";
  return what + " " + std::to_string(requests.size()) + " " + sha256(texts) + "\n";
}

std::vector<std::string> names_of_files(const std::vector<ShippedFile>& files) {
  std::vector<std::string> names;
  for (const ShippedFile& file : files)
    names.push_back(fs::path(file.name).stem().string());
  return names;
}

std::vector<Request> requests_of_chart(const std::string& scene) {
  std::vector<Request> all;
  for (const ChartModel& model : chart_models(chart_body(scene, {}).shape))
    all.push_back(
        {.settings = model_case(scene, {}, model, 4), .reference = std::nullopt});
  return all;
}

std::string now() {
  std::string text;
  for (const std::string& scene : names_of_files(shipped_scenes()))
    for (const Request& request : requests(read_run(scene, {})))
      text += "scene " + text_of(request) + "\n";
  for (const std::string& sweep : names_of_files(shipped_sweeps()))
    text += together("sweep " + sweep, all_requests(read_sweep(sweep, SIZE_MAX)));
  for (const CatalogueEntry& table : catalogue())
    text += together("table " + std::string(table.name), plan_of(table).requests);
  for (const char* scene : {"compression", "bending", "kidney"})
    text += together(std::string("chart ") + scene, requests_of_chart(scene));
  return text;
}

std::vector<std::string> lines_of(std::istream&& text) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

}  // namespace

BOOST_AUTO_TEST_CASE(settings_of_all_that_is_shipped_are_as_stored) {
  const std::string ours = now();
  std::ofstream("build/golden_settings.txt") << ours;  // to compare with, or to copy
  const auto expected = lines_of(std::ifstream(golden));
  auto got = lines_of(std::istringstream(ours));
  BOOST_TEST_REQUIRE(!expected.empty());
  // A table that is new, and not stored yet, makes nobody compute anew.
  const auto table_of = [](const std::string& line) {
    return line.starts_with("table ") ? line.substr(0, line.find(' ', 6)) : "";
  };
  std::set<std::string> stored;
  for (const std::string& line : expected) stored.insert(table_of(line));
  std::erase_if(
      got, [&](const std::string& line) { return !stored.contains(table_of(line)); });
  BOOST_TEST(got == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_key_is_the_hash_of_what_was_asked_and_of_the_revision) {
  for (const Request& request : requests(run_of("compression", {"cells=2,2,2"}))) {
    const Mesh mesh = build_mesh(request.settings.body);
    nlohmann::json all = nlohmann::json::parse(text_of(request));
    all["mesh"] = mesh.sha256();
    const std::string identity = sha256(all.dump());
    BOOST_TEST(case_identity(request, mesh) == identity);
    BOOST_TEST(case_key(request, mesh) == sha256(identity + ' ' + build_info::revision));
  }
}

BOOST_AUTO_TEST_SUITE_END()
