#include "comparisons/sweeps/sweep_file.hpp"

#include <algorithm>
#include <array>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "comparisons/shipped/shipped.hpp"
#include "comparisons/sweeps/planned_cases.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/comparisons/settings.hpp"
#include "tests/comparisons/sweeps/sweep_of.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;
namespace fs = std::filesystem;
namespace data = boost::unit_test::data;

BOOST_AUTO_TEST_SUITE(sweep_file_test)

namespace {

std::string message_of(const std::string& text, std::size_t most = 1000) {
  try {
    MeshHashes meshes;
    planned_cases(sweep_of(text, most), meshes, 1, 1);
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.substr(std::min(message.find("sweep.toml"), message.size()));
  }
  return "accepted";
}

/// The words "compression mss-cf 0.25 0.05" of each request.
std::vector<std::string> cases_of(const Sweep& sweep) {
  std::vector<std::string> cases;
  for (const Request& request : all_requests(sweep)) {
    const CaseSettings& s = request.settings;
    std::ostringstream text;
    text << s.scene << " " << label(s) << " " << s.material.poisson_ratio << " "
         << s.deformation.value_or(0);
    cases.push_back(text.str());
  }
  return cases;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sweep_is_the_product_of_its_lists_the_last_fastest) {
  const auto cases = cases_of(sweep_of(R"(
scene = ["compression", "shearing"]
method = "mss-cf"
nu = {from = 0, to = 0.4, count = 3}
deformation = "5%"
)"));
  const std::vector<std::string> expected{
      "compression mss-cf 0 0.05",   "compression mss-cf 0.2 0.05",
      "compression mss-cf 0.4 0.05", "shearing mss-cf 0 0.05",
      "shearing mss-cf 0.2 0.05",    "shearing mss-cf 0.4 0.05"};
  BOOST_TEST(cases == expected, boost::test_tools::per_element());
}

// As in a scene, tables are all made in one body; of texts each case has one.
BOOST_AUTO_TEST_CASE(tables_of_cuts_are_one_value_and_texts_are_choices) {
  const std::string common = "scene = \"compression\"\nmethod = \"mss-cf\"\n";
  const auto cuts_of_each = [](const Sweep& sweep) {
    std::vector<std::size_t> counts;
    for (const Request& request : all_requests(sweep))
      counts.push_back(request.settings.body.cuts.size());
    return counts;
  };
  const std::string one = "[[cut]]\nkind = \"split\"\nplane = [0, 0, 1, 0.025]\n",
                    other = "[[cut]]\nkind = \"split\"\nplane = [1, 0, 0, 0.025]\n";
  BOOST_TEST(cuts_of_each(sweep_of(common + one + other)) == std::vector<std::size_t>{2},
             boost::test_tools::per_element());
  BOOST_TEST(cuts_of_each(sweep_of(
                 common + "cut = [\"\", \"split,plane=0,0,1,0.025\", "
                          "\"split,plane=0,0,1,0.025,split,plane=1,0,0,0.025\"]\n")) ==
                 (std::vector<std::size_t>{0, 1, 2}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(each_of_the_cases_has_its_own_keys) {
  const Sweep sweep = sweep_of(R"(
method = ["mss-cf", "fem-hooke"]
nu = 0.3
fields = true
[[cases]]
scene = "tension"
[[cases]]
scene = "torsion"
deformation = ["1deg", 0.5]
nu = 0.1
cells = [[2, 2, 2], [4, 4, 4]]
)");
  BOOST_TEST(sweep.with_fields);
  const auto cases = cases_of(sweep);
  BOOST_TEST(cases.size() == 2U + 2 * 2 * 2);
  BOOST_TEST(cases[0] == "tension mss-cf 0.3 0.05");
  BOOST_TEST(cases[1] == "tension fem-hooke:q1-sri 0.3 0.05");
  BOOST_TEST(cases[2].starts_with("torsion mss-cf 0.1 0.0174"), cases[2]);
  BOOST_TEST((all_requests(sweep)[3].settings.body.block.cells == std::array{4, 4, 4}));
}

BOOST_AUTO_TEST_CASE(ranges_hold_the_numbers_that_lists_would) {
  const Sweep sweep = sweep_of(
      "scene = 'compression'\nmethod = 'mss-cf'\nnu = {from = 0, to = 0.45, count = "
      "10}\n");
  const std::vector<double> list{0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45};
  const std::vector<Request> requests = all_requests(sweep);
  for (std::size_t i = 0; i < list.size(); ++i)
    BOOST_TEST(requests.at(i).settings.material.poisson_ratio == list[i]);
}

BOOST_AUTO_TEST_CASE(a_scene_s_own_methods_are_taken_where_none_is_given) {
  BOOST_TEST(cases_of(sweep_of("scene = 'compression'\n")).size() ==
             run_of("compression", {}).methods.size());
}

namespace {

struct Bad {
  const char *text, *message;
};
std::ostream& operator<<(std::ostream& out, const Bad& bad) {
  return out << bad.message;
}
const std::vector<Bad> bad_sweeps{
    {"nu = 0.2\n", "sweep.toml:1:1: key 'scene': expected the name of a scene, got none"},
    {"scene = []\n", "sweep.toml:1:9: scene: expected at least one value, got an empty"},
    {"scene = 'compression'\nnu = []\n",
     "sweep.toml:2:6: nu: expected at least one value, got an empty list"},
    {"scene = 'compression'\nnü = 1\n", "sweep.toml:2:2: expected TOML"},
    {"scene = 'compression'\nmu = 1\n",
     "sweep.toml:2:1: unknown key 'mu', did you mean 'nu'? expected one of scene"},
    {"scene = 'compression'\nnu = [0.1, 0.5]\n",
     "sweep.toml:2:12: nu: expected a number in (-1, 0.5), got 0.5"},
    {"scene = 'compression'\nnu = {from = 0, to = 0.4}\n",
     "sweep.toml:2:6: nu: count: expected an integer in [2, 1000000], got none"},
    {"scene = 'compression'\nnu = {from = 0, to = 0.4, count = 1}\n",
     "sweep.toml:2:6: nu: count: expected an integer in [2, 1000000], got 1"},
    {"scene = 'compression'\nnu = {from = 0, count = 2}\n",
     "sweep.toml:2:6: nu: to: expected a number, got none"},
    {"scene = 'compression'\nnu = {from = '0', to = 0.4, count = 2}\n",
     "sweep.toml:2:14: from: expected a finite number, plain or with a unit, got '0'"},
    {"scene = 'compression'\nnu = {from = 0, to = [0.4], count = 2}\n",
     "sweep.toml:2:22: to: expected a finite number, plain or with a unit, got [0.4]"},
    {"scene = 'compression'\nnu = {from = nan, to = 0.4, count = 2}\n",
     "sweep.toml:2:14: from: expected a finite number, plain or with a unit, got nan"},
    {"scene = 'compression'\ndeformation = {from = '5%', to = 0.4, count = 2}\n",
     "sweep.toml:2:15: deformation: expected from and to in one unit, got '5%' and "
     "'0.4'"},
    {"scene = 'compression'\nnu = {from = 0, to = 0.4, count = 2, by = 3}\n",
     "sweep.toml:2:38: unknown key of a range 'by', expected one of from, to, count"},
    {"scene = 'compression'\ncells = {from = 2, to = 4, count = 2}\n",
     "sweep.toml:2:9: cells: expected a value, or a list of values, got a table"},
    {"scene = 'compression'\nmesh = 'a.msh'\ncells = [[2, 2, 2]]\n",
     "sweep.toml:3:10: cells: expected no cells beside mesh 'a.msh', which stands in its "
     "place, got [2, 2, 2]"},
    {"scene = 'compression'\ncases = 3\n",
     "sweep.toml:2:9: cases: expected tables, [[cases]], got others"},
    {"fields = 1\nscene = 'compression'\n", "sweep.toml:1:10: fields: expected"},
    {"scene = ['compression', 'compresion']\n",
     "sweep.toml:1:25: scene: unknown scene 'compresion', did you mean 'compression'?"},
    {"scene = 'scenes/none.toml'\n",
     "sweep.toml:1:9: scene: expected a readable scene file, got '"},
    {"scene = 'compression'\nreference = 'fem-hookee'\n", "sweep.toml:2:13: reference"}};

}  // namespace

BOOST_DATA_TEST_CASE(a_bad_sweep_is_refused_with_line_and_column,
                     data::make(bad_sweeps)) {
  BOOST_TEST(message_of(sample.text).starts_with(sample.message),
             message_of(sample.text));
}

BOOST_AUTO_TEST_CASE(ranges_may_have_a_unit_and_hold_the_numbers_of_a_list) {
  const auto keys = [](const std::string& deformations) {
    std::vector<double> all;
    for (const Request& request :
         all_requests(sweep_of("scene = 'compression'\nmethod = 'mss-cf'\n"
                               "deformation = " +
                               deformations + "\n")))
      all.push_back(*request.settings.deformation);
    return all;
  };
  const std::vector<double> expected{0.05, 0.1, 0.15};
  BOOST_TEST(keys("{from = '5%', to = '15%', count = 3}") == expected,
             boost::test_tools::per_element());
  BOOST_TEST(keys("{from = 0.05, to = 0.15, count = 3}") == expected,
             boost::test_tools::per_element());
  // Both ends are the numbers that are written, to the last digit.
  BOOST_TEST(keys("{from = 0.1234567890123456, to = 0.2, count = 2}").front() ==
             0.1234567890123456);
}

BOOST_AUTO_TEST_CASE(ranges_may_be_written_as_texts) {
  const std::string scene = "scene = \"compression\"\nmethod = \"mss-cf\"\n";
  BOOST_TEST(cases_of(sweep_of(scene + "nu = \"0:0.4:3\"\n")) ==
                 cases_of(sweep_of(scene + "nu = [0, 0.2, 0.4]\n")),
             boost::test_tools::per_element());
  BOOST_TEST(cases_of(sweep_of(scene + "nu = [\"0:0.4:3\", 0.45]\n")) ==
                 cases_of(sweep_of(scene + "nu = [0, 0.2, 0.4, 0.45]\n")),
             boost::test_tools::per_element());
  BOOST_TEST(cases_of(sweep_of(scene + "deformation = \"0.1%:10%:log:3\"\n")) ==
                 cases_of(sweep_of(scene + "deformation = [0.001, 0.01, 0.1]\n")),
             boost::test_tools::per_element());
  BOOST_TEST(message_of(scene + "nu = \"0:0.4:log:3\"\n") ==
             "sweep.toml:3:6: nu: expected a value, or a range FROM:TO:COUNT or "
             "FROM:TO:log:COUNT with FROM < TO, got '0:0.4:log:3'");
}

BOOST_AUTO_TEST_CASE(scenes_and_meshes_stand_beside_the_sweep) {
  const OwnFolder own;
  const fs::path folder = own.path / "below";
  fs::create_directories(folder / "scenes");
  std::ofstream(folder / "scenes" / "mine.toml")
      << "test = 'compression'\nmethod = 'mss-cf'\nmesh = 'mine.msh'\nyoung = 1e4\n"
         "nu = 0.25\ndensity = 1000\ndeformation = '5%'\n";
  std::ofstream(folder / "sweep.toml") << "scene = 'scenes/mine.toml'\n";
  const Sweep sweep = read_sweep((folder / "sweep.toml").string(), 10);
  const std::vector<Request> requests = all_requests(sweep);
  BOOST_TEST(requests.size() == 1U);
  const CaseSettings& settings = requests.front().settings;
  BOOST_TEST(settings.scene == "mine");
  BOOST_TEST(settings.body.file == (folder / "scenes" / "mine.msh").string());
}

BOOST_AUTO_TEST_CASE(large_products_need_to_be_meant) {
  const std::string text =
      "scene = 'compression'\nmethod = 'mss-cf'\nnu = {from = 0, to = 0.4, count = 30}\n"
      "seed = {from = 1, to = 40, count = 40}\n";
  BOOST_TEST(message_of(text, 1199) ==
             "sweep.toml: cases: expected at most 1199 without --yes, got 1200");
}

BOOST_AUTO_TEST_CASE(shipped_sweeps_can_be_read) {
  std::set<std::string> names;
  for (const ShippedFile& sweep : shipped_sweeps()) {
    const std::string name = fs::path(sweep.name).stem().string();
    BOOST_TEST(!all_requests(read_sweep(name, 1000)).empty(), name);
    names.insert(name);
  }
  for (const char* name : {"nu", "refinement", "diagonal-ratio", "deformation"})
    BOOST_TEST(names.contains(name), name);
  BOOST_TEST(all_requests(read_sweep("nu", 1000)).size() == 330U);
}

// The scene has load-times and load-fractions, which a duration replaces.
BOOST_AUTO_TEST_CASE(a_sweep_replaces_what_the_scene_says_otherwise) {
  const Sweep sweep =
      sweep_of("scene = 'tissue-relaxation'\nmethod = 'mss-tissue'\nduration = [3, 4]\n");
  const std::vector<Request> requests = all_requests(sweep);
  BOOST_REQUIRE(requests.size() == 2U);
  BOOST_TEST(requests.front().settings.dynamics.duration == 3);
  BOOST_TEST(requests.front().settings.dynamics.load.empty());
  BOOST_TEST(message_of("scene = 'tissue-relaxation'\nmethod = 'mss-tissue'\n"
                        "duration = 3\nrate = 1\n")
                 .find("which it would replace") != std::string::npos);
}

// A step from one law to another where the deformation passes .02 would be no finding.
BOOST_AUTO_TEST_CASE(one_law_is_the_reference_of_all) {
  const auto references = [](const std::string& more) {
    std::set<std::string> labels;
    for (const Request& request : all_requests(
             sweep_of("scene = ['compression', 'torsion']\nmethod = 'mss-cf'\n" + more)))
      labels.insert(reference_label(request));
    return labels;
  };
  using Labels = std::set<std::string>;
  BOOST_TEST((references("deformation = [0.01, 0.02]") == Labels{"fem-hooke:q1-sri"}));
  BOOST_TEST((references("deformation = [0.01, 0.021]") == Labels{"fem-stvk:q1-sri"}));
  BOOST_TEST((references("deformation = 0.01\nnu = [0, 0.3]\n[[cases]]\n[[cases]]\n"
                         "deformation = 0.1") == Labels{"fem-stvk:q1-sri"}));
  BOOST_TEST(
      (references("deformation = 0.1\nsolver = 'verlet'\nload-times = 1\n"
                  "load-fractions = [[0.1], [0.15]]") == Labels{"fem-hooke:q1-sri"}));
  BOOST_TEST((references("deformation = [0.01, 0.1]\nreference = 'fem-hencky'") ==
              Labels{"fem-hencky:q1-sri"}));
  const auto takes_usual = [](const std::string& text) {
    return takes_usual_reference(sweep_of(text));
  };
  BOOST_TEST(takes_usual("scene = 'compression'\nnu = [0.1, 0.2]"));
  BOOST_TEST(!takes_usual("scene = 'compression'\nreference = 'fem-hencky'"));
  BOOST_TEST(!takes_usual("scene = 'tissue-shearing'\ncells = [1, 1, 1]"));
}

BOOST_AUTO_TEST_SUITE_END()
