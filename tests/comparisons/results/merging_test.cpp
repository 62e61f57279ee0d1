#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <boost/test/unit_test.hpp>
#include <csignal>
#include <fstream>

#include "comparisons/results/result_file.hpp"
#include "comparisons/store/hdf5.hpp"
#include "comparisons/store/overlay_file.hpp"
#include "comparisons/system/blas.hpp"
#include "comparisons/system/processor.hpp"
#include "tests/comparisons/settings.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(merging_test)

namespace {

std::vector<CaseResult> results_of(const std::vector<std::string>& settings,
                                   MeshStore& meshes) {
  return run_study(requests(run_of("compression", settings)), meshes, 1,
                   [](std::size_t, std::size_t) {});
}

}  // namespace

// A sweep that stores fields computes what the file holds without them.
BOOST_AUTO_TEST_CASE(merging_adds_fields_that_are_lacking) {
  const OwnFolder own;
  MeshStore meshes;
  const auto results = results_of({"cells=4,4,4", "method=mss-cf,fem-hooke"}, meshes);
  ResultFile bare(own.path / "bare.h5");
  bare.put(results, false, meshes);
  BOOST_TEST(bare.stored().with_fields.empty());
  write_results(own.path / "full.h5", results, meshes);
  const auto absorbed = bare.absorb(own.path / "full.h5");
  BOOST_TEST(absorbed.conflicts.empty());
  BOOST_TEST(bare.stored().with_fields.size() == results.size());
  BOOST_TEST(stored_keys(own.path / "bare.h5").with_fields.size() == results.size());
}

// Files of before 0.3.0 lack the family, which says nothing that the method does not.
BOOST_AUTO_TEST_CASE(merging_with_an_older_file_finds_no_conflict) {
  const OwnFolder own;
  MeshStore meshes;
  const auto results = results_of({"cells=4,4,4", "method=mss-cf,fem-hooke"}, meshes);
  const auto older = own.path / "older.h5", newer = own.path / "newer.h5";
  for (const auto& file : {older, newer}) write_results(file, results, meshes);
  const hid_t file = H5Fopen(older.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  BOOST_TEST_REQUIRE(H5Ldelete(file, "cases/family", H5P_DEFAULT) >= 0);
  H5Fclose(file);
  BOOST_TEST(!read_cases(older, Revisions::own).texts.contains("family"));
  for (const auto& [to, from] : {std::pair(newer, older), std::pair(older, newer)}) {
    const auto absorbed = ResultFile(to).absorb(from);
    BOOST_TEST(absorbed.conflicts.empty());
    BOOST_TEST(absorbed.already_there == results.size());
  }
}

// What is copied is of one state of the file: reading pages while they are written gave
// other numbers, or none, without an error.
BOOST_AUTO_TEST_CASE(merging_reads_beside_a_writer) {
  const OwnFolder own;
  const auto from = own.path / "from.h5";
  MeshStore meshes;
  auto results = results_of({"cells=6,6,6", "method=mss-cf,fem-hooke,mss-fd"}, meshes);
  // Two states of the file; in each all numbers belong together.
  const auto stamp = [&](double value) {
    for (CaseResult& result : results) {
      result.measures.volume_error = value;
      for (Vector3& u : result.solution.displacements) u = Vector3::Constant(value);
    }
  };
  stamp(1);
  ResultFile(from).put(results, true, meshes);
  const pid_t child = fork();
  BOOST_TEST_REQUIRE(child >= 0);
  if (child == 0) {
    ResultFile file(from);
    for (double value = 2;; value += 1) {
      stamp(value);
      file.put(results, true, meshes);
      usleep(1000);
    }
  }
  for (int round = 0; round < 30; ++round) {
    const auto to = own.path / ("to" + std::to_string(round) + ".h5");
    const auto absorbed = ResultFile(to).absorb(from);
    BOOST_TEST(absorbed.added == results.size());
    const auto root = hdf5::open_file(to);
    for (const CaseResult& result : results) {
      const auto values = hdf5::read_table(hdf5::open_group(root, "fields/" + result.key),
                                           "displacement");
      BOOST_TEST_REQUIRE(values.has_value());
      BOOST_TEST(std::ranges::count(*values, values->front()) ==
                 static_cast<std::ptrdiff_t>(values->size()));
    }
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

// The rounding is such as other processors and another BLAS make: that of the number
// itself, or of others that cancel in it.
BOOST_AUTO_TEST_CASE(rounding_is_no_conflict_of_a_merge) {
  const OwnFolder own;
  MeshStore meshes;
  auto results = results_of({"cells=2,2,2"}, meshes);
  write_results(own.path / "ours.h5", results, meshes);
  *results[0].measures.plate_force *= 1 + 1e-12;
  results[0].measures.torque = Vector3(1e-16, 0, 0);
  write_results(own.path / "theirs.h5", results, meshes);
  ResultFile ours(own.path / "ours.h5");
  const auto absorbed = ours.absorb(own.path / "theirs.h5");
  BOOST_TEST(absorbed.conflicts.empty());
  BOOST_TEST_REQUIRE(absorbed.roundings.size() == 1U);
  BOOST_TEST(
      absorbed.roundings[0].find("by rounding; computed with " + instructions() + ", " +
                                 blas_name() + " here") != std::string::npos,
      absorbed.roundings[0]);
}

// A number's rounding is told by the measures that a sum may cancel against, not by those
// of another unit.
BOOST_AUTO_TEST_CASE(rounding_is_told_by_the_measures_of_one_unit) {
  const OwnFolder own;
  const auto a = own.path / "a.h5", b = own.path / "b.h5";
  MeshStore meshes;
  auto results = results_of({"cells=4,4,4", "method=mss-cf,fem-hooke"}, meshes);
  results.resize(1);
  Measures& m = results[0].measures;
  m.plate_force = 1e9;
  m.plate_torque = 1e-6;
  m.volume_error = 1e-4;
  write_results(a, results, meshes);
  const auto merged = [&](const auto& change) {
    CaseResult other = results[0];
    change(other.measures);
    fs::remove(b);
    write_results(b, {&other, 1}, meshes);
    return ResultFile(a).absorb(b);
  };
  const auto torque = merged([](Measures& other) { other.plate_torque = 2e-6; });
  BOOST_TEST(torque.conflicts.empty());
  BOOST_TEST(torque.roundings.size() == 1U);
  const auto volume = merged([](Measures& other) { other.volume_error = 1.02e-4; });
  BOOST_TEST(volume.conflicts.size() == 1U);
  const auto force = merged([](Measures& other) { other.plate_force = 1e9 + 2; });
  BOOST_TEST(force.conflicts.size() == 1U);
}

// A case that both files have with other figures is kept as it is, and named.
BOOST_AUTO_TEST_CASE(conflicts_of_a_merge_are_reported) {
  const OwnFolder own;
  MeshStore meshes;
  auto results = results_of({"cells=2,2,2"}, meshes);
  write_results(own.path / "ours.h5", results, meshes);
  const double force = *results[0].measures.plate_force;
  *results[0].measures.plate_force *= 1 + 2e-9;
  results[1].measures.wall_s = 77;  // times may differ
  write_results(own.path / "theirs.h5", results, meshes);
  ResultFile ours(own.path / "ours.h5");
  const auto absorbed = ours.absorb(own.path / "theirs.h5");
  BOOST_TEST(absorbed.added == 0U);
  BOOST_TEST(absorbed.already_there == results.size());
  BOOST_TEST_REQUIRE(absorbed.conflicts.size() == 1U);
  BOOST_TEST(absorbed.conflicts[0].find(results[0].key +
                                        " (compression, mss-cf): plate_force differs") !=
             std::string::npos);
  BOOST_TEST(*read_results(own.path / "ours.h5", Revisions::own)
                  .at(results[0].key)
                  .measures.plate_force == force);
}

BOOST_AUTO_TEST_SUITE_END()
