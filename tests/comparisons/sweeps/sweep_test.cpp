#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <exception>
#include <fstream>
#include <new>
#include <nlohmann/json.hpp>
#include <set>

#include "comparisons/commands/commands.hpp"
#include "comparisons/results/known_results.hpp"
#include "comparisons/running/cost.hpp"
#include "comparisons/shipped/shipped.hpp"
#include "comparisons/sweeps/sweep_file.hpp"
#include "comparisons/sweeps/sweep_run.hpp"
#include "comparisons/system/memory.hpp"
#include "meshing/files/mesh_files.hpp"
#include "meshing/generators/generate_block.hpp"
#include "meshing/input_error.hpp"
#include "tests/comparisons/own_folder.hpp"
#include "tests/comparisons/settings.hpp"

using namespace springcheck;
namespace fs = std::filesystem;
namespace data = boost::unit_test::data;

BOOST_AUTO_TEST_SUITE(sweep_test)

namespace {

Sweep sweep_of(const std::string& text, std::size_t most = 1000) {
  const OwnFolder own;
  std::ofstream(own.path / "sweep.toml") << text;
  return read_sweep((own.path / "sweep.toml").string(), most);
}

/// As the command line does.
ExitStatus run(const Command& command, std::vector<std::string> words) {
  DeclaredCommand declared(command);
  std::ranges::reverse(words);  // as CLI11 takes them
  declared.parser.parse(std::move(words));
  return declared.action();
}

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

/// "compression mss-cf 0.25 0.05" of each request.
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
  // Both ends are what is written, to the last digit.
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

// So that the reference is computed once, whatever the order of the file's keys.
BOOST_AUTO_TEST_CASE(cases_of_one_reference_follow_each_other) {
  const Sweep sweep = sweep_of(
      "scene = 'compression'\nmethod = ['mss-cf', 'fem-stvk', 'mss-cf']\n"
      "cells = [1, 1, 1]\nnu = [0.1, 0.2]\ndeformation = [0.02, 0.03]\n");
  MeshHashes meshes;
  std::vector<std::string> order;
  for (const PlannedCase& planned : planned_cases(sweep, meshes, 1, 1)) {
    const CaseSettings settings = request_of(sweep, planned).settings;
    std::ostringstream text;
    text << settings.material.poisson_ratio << " " << *settings.deformation << " "
         << settings.method.name;
    order.push_back(text.str());
  }
  BOOST_TEST(order == (std::vector<std::string>{"0.1 0.02 mss-cf", "0.1 0.02 fem-stvk",
                                                "0.1 0.03 mss-cf", "0.1 0.03 fem-stvk",
                                                "0.2 0.02 mss-cf", "0.2 0.02 fem-stvk",
                                                "0.2 0.03 mss-cf", "0.2 0.03 fem-stvk"}));
}

// A request holds all its settings, some 10 kB; what is planned some 100 bytes.
BOOST_AUTO_TEST_CASE(what_is_planned_takes_little_memory) {
  const Sweep sweep = sweep_of(
      "scene = 'compression'\nmethod = 'mss-cf'\ncells = [1, 1, 1]\n"
      "nu = {from = 0.1, to = 0.4, count = 100}\n"
      "deformation = {from = 0.01, to = 0.05, count = 100}\n",
      10'000);
  MeshHashes meshes;
  const double before = resident_memory();
  BOOST_TEST(planned_cases(sweep, meshes, 1, 1).size() == 10'000U);
  BOOST_TEST(resident_memory() - before < 10'000 * 2e3);
}

// Meshes of files have to be read to tell what is asked; others are generated when they
// are needed.
BOOST_AUTO_TEST_CASE(planning_reads_meshes_of_files_alone) {
  const OwnFolder own;
  write_mesh(generate_block({.size = {1, 1, 1}, .cells = {1, 1, 1}}),
             own.path / "block.msh");
  const std::string rest =
      "test = 'compression'\nmethod = 'mss-cf'\nyoung = 1e4\nnu = 0.25\n"
      "density = 1000\ndeformation = '5%'\n";
  std::ofstream(own.path / "good.toml") << "mesh = 'block.msh'\n" << rest;
  std::ofstream(own.path / "bad.toml") << "mesh = 'none.msh'\n" << rest;
  const auto planned = [&](const std::string& scene) {
    const auto file = own.path / "sweep.toml";
    std::ofstream(file) << "scene = './" << scene << ".toml'\n";
    MeshHashes meshes;
    return planned_cases(read_sweep(file.string(), 10), meshes, 1, 1).size();
  };
  BOOST_TEST(planned("good") == 1U);
  BOOST_CHECK_EXCEPTION(planned("bad"), InputError, [](const InputError& error) {
    return std::string(error.what()).find("none.msh") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(a_long_sweep_runs_in_parts_and_leaves_out_nothing) {
  const OwnFolder own;
  const Sweep sweep = sweep_of(
      "scene = 'compression'\nmethod = 'mss-cf'\ncells = [1, 1, 1]\n"
      "nu = {from = 0.1, to = 0.4, count = 21}\n"
      "deformation = {from = 0.01, to = 0.05, count = 50}\n",
      1050);
  ResultFile file(own.path / "long.h5");
  MeshHashes meshes;
  const SweepOutcome outcome =
      run_cases(file, sweep, planned_cases(sweep, meshes, 1, 1), 2);
  BOOST_TEST(outcome.count.at(Status::ok) == 1050);
  std::set<std::string> keys;
  for (const Request& request : all_requests(sweep))
    keys.insert(
        key_of_identity(case_identity(request, meshes.of(request.settings.body))));
  BOOST_TEST(keys.size() == 1050U);
  for (const auto& [key, status] : stored_keys(own.path / "long.h5").statuses)
    BOOST_TEST(keys.contains(key));
  BOOST_TEST(stored_keys(own.path / "long.h5").statuses.size() == 1050U);
}

// What a case throws is told at the end, when all others are in the file.
BOOST_AUTO_TEST_CASE(a_case_without_an_answer_does_not_end_a_sweep) {
  const OwnFolder own;
  MeshStore meshes;
  std::vector<Request> requests = all_requests(sweep_of(
      "scene = 'compression'\nmethod = ['mss-cf', 'mss-fd']\ncells = [1, 1, 1]\n"));
  requests[0].settings.method.solve = [](const auto&...) -> Solution {
    throw std::bad_alloc();
  };
  ResultFile file(own.path / "a.h5");
  SweepOutcome outcome;
  for (int part = 0; part < 2; ++part)
    run_into(
        file, requests, false, meshes, 1, {}, [](std::size_t, std::size_t) {}, outcome);
  BOOST_TEST(outcome.count.at(Status::ok) == 2);
  BOOST_TEST(outcome.count.at(Status::error) == 2);
  BOOST_REQUIRE(outcome.failure);
  BOOST_CHECK_THROW(std::rethrow_exception(outcome.failure), NoAnswer);
  BOOST_TEST(file.stored().statuses.size() == 1U);

  ResultFile none(own.path / "none.h5");
  requests.pop_back();
  run_into(
      none, requests, true, meshes, 1, {}, [](std::size_t, std::size_t) {}, outcome);
  BOOST_CHECK_NO_THROW(write_xdmf_beside(own.path / "none.h5"));
  BOOST_TEST(!fs::exists(own.path / "none.h5"));
}

BOOST_AUTO_TEST_CASE(what_was_refused_is_told_with_its_reason) {
  const OwnFolder own;
  MeshStore meshes;
  ResultFile file(own.path / "refused.h5");
  const Sweep sweep = sweep_of(
      "scene = 'compression'\nmethod = ['mss-affine', 'mss-nfd']\ncells = [1, 1, 2]\n");
  MeshHashes hashes;
  const SweepOutcome outcome =
      run_cases(file, sweep, planned_cases(sweep, hashes, 1, 1), 1);
  BOOST_TEST(outcome.count.at(Status::refused) == 1);
  BOOST_REQUIRE(outcome.reasons.size() == 1U);
  BOOST_TEST(outcome.reasons.begin()->first.method == "mss-nfd");
  BOOST_TEST(!outcome.reasons.begin()->first.words.empty());
}

BOOST_AUTO_TEST_CASE(shards_are_disjoint_and_whole) {
  const OwnFolder own;
  const std::string sweep = (own.path / "s.toml").string();
  std::ofstream(sweep) << "scene = 'compression'\nmethod = ['fem-hooke', 'mss-cf']\n"
                          "cells = [2, 2, 2]\nnu = [0.1, 0.2, 0.3]\n"
                          "element = ['q1', 'q1-sri']\n";  // springs read no element
  std::size_t cases = 0;
  for (int shard = 1; shard <= 4; ++shard) {
    const fs::path file = own.path / ("part" + std::to_string(shard) + ".h5");
    run(sweep_command(),
        {sweep, "--out", file, "--jobs", "2", "--shard", std::to_string(shard) + "/4"});
    cases += read_cases(file, Revisions::own).rows;
    run(merge_command(), {own.path / "all.h5", file});
  }
  BOOST_TEST(cases == 9U);
  BOOST_TEST(read_cases(own.path / "all.h5", Revisions::own).rows == 9U);
  // Nothing is left to do, and merging again changes nothing.
  run(sweep_command(), {sweep, "--out", own.path / "all.h5", "--jobs", "1"});
  BOOST_TEST(run(merge_command(), {own.path / "all.h5", own.path / "part1.h5"}) ==
             ExitStatus::done);
  const Columns all = read_cases(own.path / "all.h5", Revisions::own);
  BOOST_TEST(all.rows == 9U);

  run(sweep_command(), {sweep, "--out", own.path / "whole.h5", "--jobs", "2"});
  const Columns whole = read_cases(own.path / "whole.h5", Revisions::own);
  const auto force_of = [](const Columns& table, const std::string& key) {
    const auto& keys = table.texts.at("key");
    return table.numbers.at("plate_force")
        .values.at(static_cast<std::size_t>(std::ranges::find(keys, key) - keys.begin()));
  };
  for (const std::string& key : whole.texts.at("key"))
    BOOST_TEST(force_of(all, key) == force_of(whole, key));  // the same bits
}

BOOST_AUTO_TEST_CASE(only_failed_runs_what_is_there_and_not_ok) {
  const OwnFolder own;
  const fs::path file = own.path / "a.h5";
  const std::string sweep = (own.path / "s.toml").string();
  std::ofstream(sweep) << "scene = 'compression'\nmethod = 'fem-hooke'\n"
                          "cells = [2, 2, 2]\nnu = [0.1, 0.2, 0.3]\n";
  run(sweep_command(), {sweep, "--out", file, "--jobs", "1"});
  MeshStore meshes;
  const Request request =
      all_requests(sweep_of("scene = 'compression'\nmethod = 'fem-hooke'\n"
                            "cells = [2, 2, 2]\nnu = 0.2\n"))
          .front();
  CaseResult failed{};
  failed.request = request;
  failed.key = case_key(request, meshes.mesh(request.settings.body));
  failed.status = Status::not_converged;
  ResultFile(file).put({&failed, 1}, false, meshes);
  BOOST_TEST(ResultFile(file).stored().statuses.size() == 3U);
  run(sweep_command(),
      {sweep, "--out", file, "--jobs", "1"});  // failed or not, it is there
  BOOST_TEST(
      (ResultFile(file).stored().statuses.at(failed.key) == Status::not_converged));
  run(sweep_command(), {sweep, "--out", file, "--jobs", "1", "--only-failed"});
  BOOST_TEST((ResultFile(file).stored().statuses.at(failed.key) == Status::ok));
  BOOST_TEST(read_cases(file, Revisions::own).rows == 3U);
}

// The estimate is of the right size and grows with the mesh: never trusted further.
BOOST_AUTO_TEST_CASE(the_estimate_counts_each_simulation_once) {
  const auto seconds = [](const std::string& cells) {
    CostEstimate cost;
    for (const Request& request : all_requests(sweep_of(
             "scene = 'compression'\nmethod = ['mss-cf', 'mss-fd']\ncells = " + cells)))
      cost.add(request);
    return cost.seconds();
  };
  BOOST_TEST(seconds("[10, 10, 10]") == 0.5 + 0.5 + 0.6,  // one reference for both
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(seconds("[20, 20, 20]") > 8 * seconds("[10, 10, 10]"));
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
