#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>
#include <set>
#include <sstream>

#include "comparisons/commands/commands.hpp"
#include "comparisons/results/known_results.hpp"
#include "comparisons/running/cost.hpp"
#include "comparisons/sweeps/sweep_run.hpp"
#include "comparisons/system/memory.hpp"
#include "meshing/basics/input_error.hpp"
#include "meshing/files/mesh_files.hpp"
#include "meshing/generators/generate_block.hpp"
#include "tests/comparisons/sweeps/sweep_of.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(sweep_test)

namespace {

/// Runs a command as the command line does.
ExitStatus run(const Command& command, std::vector<std::string> words) {
  DeclaredCommand declared(command);
  std::ranges::reverse(words);  // as CLI11 takes them
  declared.parser.parse(std::move(words));
  return declared.action();
}

}  // namespace

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

BOOST_AUTO_TEST_SUITE_END()
