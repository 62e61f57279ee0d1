#include "comparisons/running/checkpoint_file.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <boost/test/unit_test.hpp>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "comparisons/build_info/build_info.hpp"
#include "comparisons/running/simulate.hpp"
#include "comparisons/store/hdf5.hpp"
#include "comparisons/store/lock_file.hpp"
#include "meshing/basics/input_error.hpp"
#include "tests/comparisons/settings.hpp"
#include "tests/own_folder.hpp"

using namespace springcheck;

BOOST_AUTO_TEST_SUITE(checkpoint_file_test)

namespace {

namespace fs = std::filesystem;

constexpr std::size_t nodes = 1000;

/// A case whose settings are no more than its name.
CheckpointOwner owner(const std::string& name) {
  return {.identity = "identity of " + name, .settings = {{"nu", 0.25}, {"scene", name}}};
}

/// Numbers that decimal text would not keep, and some that are none.
CaseCheckpoint checkpoint_at(int step) {
  CaseCheckpoint checkpoint{.march = {.state = {},
                                      .step = step,
                                      .time = step / 3.,
                                      .dt = 1. / 7,
                                      .last_dt = 1. / 11,
                                      .steps_left = std::numeric_limits<int>::max(),
                                      .limit = std::numeric_limits<double>::infinity()},
                            .history = {}};
  for (std::size_t n = 0; n < nodes; ++n) {
    const double x = 1 / (static_cast<double>(n) + 3 + step);
    checkpoint.march.state.displacements.emplace_back(x, -x * x, -0.);
    checkpoint.march.state.velocities.emplace_back(
        5e-324, -std::numeric_limits<double>::max(), x / 3);
  }
  checkpoint.march.stiffest.assign(3 * nodes, -1. / 3);
  checkpoint.march.look_evaluations = 123456789;
  checkpoint.march.excess = {.step = step, .dt = 1. / 13, .limit = 1. / 17};
  for (int i = 0; i < 3; ++i) {
    HistorySample sample;
    sample.fill(std::numeric_limits<double>::quiet_NaN());
    sample[0] = i / 3.;
    checkpoint.history.push_back(sample);
    checkpoint.frames.push_back(
        {.sample = 2 * checkpoint.frames.size(),
         .displacements = std::vector<Vector3>(nodes, Vector3(i / 7., -0., step))});
  }
  return checkpoint;
}

template <class List>
bool same_bits(const List& a, const List& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(*a.data())) == 0;
}

void check_same(const CaseCheckpoint& a, const CaseCheckpoint& b) {
  BOOST_TEST(same_bits(a.march.state.displacements, b.march.state.displacements));
  BOOST_TEST(same_bits(a.march.state.velocities, b.march.state.velocities));
  BOOST_TEST(a.march.step == b.march.step);
  BOOST_TEST(a.march.time == b.march.time);
  BOOST_TEST(a.march.dt == b.march.dt);
  BOOST_TEST(a.march.last_dt == b.march.last_dt);
  BOOST_TEST(a.march.steps_left == b.march.steps_left);
  BOOST_TEST(a.march.limit == b.march.limit);
  BOOST_TEST(same_bits(a.march.stiffest, b.march.stiffest));
  BOOST_TEST(a.march.look_evaluations == b.march.look_evaluations);
  BOOST_TEST_REQUIRE(a.march.excess.has_value() == b.march.excess.has_value());
  if (a.march.excess) {
    BOOST_TEST(a.march.excess->step == b.march.excess->step);
    BOOST_TEST(a.march.excess->dt == b.march.excess->dt);
    BOOST_TEST(a.march.excess->limit == b.march.excess->limit);
  }
  BOOST_TEST(same_bits(a.history, b.history));
  BOOST_TEST_REQUIRE(a.frames.size() == b.frames.size());
  for (std::size_t f = 0; f < a.frames.size(); ++f) {
    BOOST_TEST(a.frames[f].sample == b.frames[f].sample);
    BOOST_TEST(same_bits(a.frames[f].displacements, b.frames[f].displacements));
  }
}

/// Expects that reading is refused with a message that has all these parts.
void expect_refused(const fs::path& file, const std::string& key, std::size_t count,
                    const std::vector<std::string>& parts) {
  try {
    (void)read_checkpoint(file, owner(key), count);
    BOOST_ERROR("no refusal of " + file.string());
  } catch (const InputError& error) {
    const std::string message = error.what();
    for (const std::string& part : parts)
      BOOST_TEST(message.find(part) != std::string::npos, message);
  }
}

std::size_t file_count(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// Files of this process cannot grow beyond so many bytes, as if the disk were full.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit now{.rlim_cur = bytes, .rlim_max = before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_checkpoint_is_read_as_it_was_written_to_the_bit) {
  const OwnFolder folder;
  const fs::path file = folder.path / "run.h5";
  BOOST_TEST(!read_checkpoint(file, owner("key"), nodes).has_value());
  for (const int step : {0, 17, 1'000'000'007}) {  // one over the other
    const CaseCheckpoint written = checkpoint_at(step);
    write_checkpoint(file, owner("key"), written);
    check_same(read_checkpoint(file, owner("key"), nodes).value(), written);
  }
  CaseCheckpoint without = checkpoint_at(1);
  without.history.clear();
  without.frames.clear();
  without.march.stiffest.clear();
  without.march.excess.reset();
  write_checkpoint(file, owner("key"), without);
  check_same(read_checkpoint(file, owner("key"), nodes).value(), without);
  BOOST_TEST(file_count(folder.path) == 1U);
}

// However often a program was killed in the middle of a save, one file is left, which the
// next save writes over.
BOOST_AUTO_TEST_CASE(what_a_killed_save_left_is_written_over) {
  const OwnFolder folder;
  const fs::path file = folder.path / "run.h5", left = folder.path / "run.h5.unfinished";
  std::ofstream(left) << std::string(1'000'000, 'x');
  write_checkpoint(file, owner("key"), checkpoint_at(5));
  check_same(read_checkpoint(file, owner("key"), nodes).value(), checkpoint_at(5));
  BOOST_TEST(file_count(folder.path) == 1U);
}

BOOST_AUTO_TEST_CASE(what_is_no_checkpoint_of_this_case_is_refused) {
  const OwnFolder folder;
  const fs::path file = folder.path / "run.h5";
  write_checkpoint(file, owner("theirs"), checkpoint_at(5));
  expect_refused(
      file, "ours", nodes,
      {"run.h5", "another case", "expected scene = \"ours\"", "got scene = \"theirs\""});
  {  // the same settings, another mesh
    CheckpointOwner other = owner("theirs");
    other.identity = "of another mesh";
    BOOST_CHECK_EXCEPTION((void)read_checkpoint(file, other, nodes), InputError,
                          [](const InputError& error) {
                            return std::string(error.what()).find("another mesh") !=
                                   std::string::npos;
                          });
  }
  expect_refused(file, "theirs", nodes + 1, {"displacement", "3003", "3000"});
  expect_refused(folder.path, "ours", nodes, {"checkpoint of springcheck"});

  const fs::path text = folder.path / "text.h5";
  std::ofstream(text) << "no HDF5\n";
  expect_refused(text, "ours", nodes, {"text.h5", "checkpoint of springcheck"});
  const fs::path empty = folder.path / "empty.h5";
  std::ofstream(empty).flush();
  expect_refused(empty, "ours", nodes, {"empty.h5", "checkpoint of springcheck"});

  const fs::path foreign = folder.path / "foreign.h5";
  {
    const hdf5::Handle root(
        H5Fcreate(foreign.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose,
        "foreign");
    hdf5::write_attribute(root, "title", std::string("something else"));
  }
  expect_refused(foreign, "ours", nodes, {"foreign.h5", "checkpoint of springcheck"});
  {
    const hdf5::Handle root(
        H5Fcreate(foreign.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose,
        "foreign");
    hdf5::write_attribute(root, "identity", std::string("identity of ours"));
  }
  expect_refused(foreign, "ours", nodes, {"foreign.h5", "'layout'"});
}

// As of a program whose histories had another column.
BOOST_AUTO_TEST_CASE(rows_of_another_width_are_refused) {
  const OwnFolder folder;
  const fs::path file = folder.path / "run.h5";
  write_checkpoint(file, owner("ours"), checkpoint_at(5));
  {
    const hdf5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose,
                            "run");
    constexpr std::size_t columns = history_columns.size() - 1;
    hdf5::remove_link(root, "history");
    hdf5::write_table(root, "history", std::vector<double>(3 * columns), columns);
  }
  expect_refused(file, "ours", nodes,
                 {"run.h5", "table 'history'",
                  fmt::format("rows of {} numbers", history_columns.size())});
}

// The case is the same, computed until then by other formulas: that must be asked for.
BOOST_AUTO_TEST_CASE(a_checkpoint_of_another_revision_is_taken_when_asked_for) {
  const OwnFolder folder;
  const fs::path file = folder.path / "run.h5";
  write_checkpoint(file, owner("ours"), checkpoint_at(5));
  {
    const hdf5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose,
                            "run");
    H5Adelete(root, "revision");
    hdf5::write_attribute(root, "revision", std::string("0123456789ab"));
  }
  expect_refused(
      file, "ours", nodes,
      {"run.h5", "another revision", "0123456789ab", "--accept-other-revisions"});
  const CaseCheckpoint taken =
      read_checkpoint(file, owner("ours"), nodes, Revisions::all).value();
  check_same(taken, checkpoint_at(5));

  // What goes on from it is of both, and stays so wherever it goes on.
  const std::string both = "0123456789ab+" + std::string(build_info::revision);
  BOOST_TEST(taken.revision == both);
  CaseCheckpoint further = checkpoint_at(6);
  further.revision = taken.revision;
  write_checkpoint(file, owner("ours"), further);
  expect_refused(file, "ours", nodes, {"another revision", both});
  const auto again = read_checkpoint(file, owner("ours"), nodes, Revisions::all);
  BOOST_TEST(again.value().revision == both);
}

BOOST_AUTO_TEST_CASE(a_truncated_file_is_refused_wherever_it_ends) {
  const OwnFolder folder;
  const fs::path file = folder.path / "run.h5";
  write_checkpoint(file, owner("key"), checkpoint_at(5));
  const auto size = fs::file_size(file);
  for (int tenth = 9; tenth > 0; --tenth) {
    fs::resize_file(file, size * static_cast<unsigned>(tenth) / 10);
    expect_refused(file, "key", nodes, {"run.h5"});
  }
}

BOOST_AUTO_TEST_CASE(counts_that_no_run_has_are_refused) {
  const OwnFolder folder;
  const fs::path file = folder.path / "run.h5";
  for (const double bad : {-1., 1e300, std::numeric_limits<double>::quiet_NaN()})
    for (const char* name : {"step", "steps_left"}) {
      write_checkpoint(file, owner("key"), checkpoint_at(5));
      {
        const hdf5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT),
                                H5Fclose, "run");
        H5Adelete(root, name);
        hdf5::write_attribute(root, name, bad);
      }
      expect_refused(file, "key", nodes, {"run.h5", name});
    }
}

BOOST_AUTO_TEST_CASE(a_write_that_fails_leaves_the_earlier_checkpoint_alone) {
  const OwnFolder folder;
  const fs::path file = folder.path / "run.h5";
  BOOST_CHECK_THROW(write_checkpoint(folder.path / "nowhere" / "run.h5", owner("key"),
                                     checkpoint_at(5)),
                    std::runtime_error);
  for (const bool has_earlier : {false, true}) {
    if (has_earlier) write_checkpoint(file, owner("key"), checkpoint_at(5));
    for (const rlim_t bytes : {0U, 1000U, 20000U, 50000U}) {
      const FileSizeLimit full(bytes);
      BOOST_CHECK_THROW(write_checkpoint(file, owner("key"), checkpoint_at(6)),
                        std::runtime_error);
    }
    BOOST_TEST(file_count(folder.path) == (has_earlier ? 1U : 0U));
    const auto left = read_checkpoint(file, owner("key"), nodes);
    BOOST_TEST(left.has_value() == has_earlier);
    if (left) check_same(*left, checkpoint_at(5));
  }
}

// Each would write over what the other saved.
BOOST_AUTO_TEST_CASE(two_runs_do_not_share_a_checkpoint) {
  const OwnFolder folder;
  const fs::path file = folder.path / "run.h5", link = folder.path / "link.h5";
  fs::create_symlink("run.h5", link);
  const CaseSettings settings = case_of(
      "compression",
      {"cells=1,1,1", "method=mss-cf", "solver=verlet", "duration=0.1", "damping=0.1"});
  MeshStore meshes;
  const auto run = [&](const fs::path& checkpoint) {
    return simulate(settings, meshes.mesh(settings.body), 1, {.checkpoint = checkpoint});
  };
  {
    const LockFile other(file);
    for (const fs::path& name : {file, link})
      BOOST_CHECK_EXCEPTION(run(name), InputError, [](const InputError& error) {
        return std::string(error.what()).find("no other process writes") !=
               std::string::npos;
      });
  }
  BOOST_TEST((run(file).status == Status::ok));
}

BOOST_AUTO_TEST_SUITE_END()
