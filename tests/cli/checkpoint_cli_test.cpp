#include "tests/cli/program.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <fstream>

BOOST_AUTO_TEST_SUITE(checkpoint_cli_test)

namespace {

const std::string pressed = "run compression --cells 4,4,4 --json ";
const std::string short_run = pressed + "--method mss-cf --duration 0.2 ";

/// The measures of a run, as they are printed.
std::string figures(const Json& result) {
  std::string text;
  for (const char* measure :
       {"volume_error", "plate_force", "force", "kinetic_energy", "strain_energy",
        "mean_deviation", "steps", "force_evaluations", "dt", "dt_limit", "history"})
    text += std::string(measure) + " " + result.at(measure).dump() + "\n";
  return text;
}

std::size_t files_named(const std::string& stem) {
  return static_cast<std::size_t>(
      std::ranges::count_if(fs::directory_iterator(folder), [&](const auto& entry) {
        return entry.path().filename().string().starts_with(stem);
      }));
}

}  // namespace

// The run is killed at no particular moment, again and again and later and later, until a
// run that was killed had saved a state.
BOOST_AUTO_TEST_CASE(a_killed_run_goes_on_to_the_bit) {
  for (const std::string precision : {"double", "float"}) {
    const std::string run =
        pressed +
        "--method mss-cf --solver verlet --duration 600 --damping 0.1 --history 7 "
        "--precision " +
        precision + " ";
    const std::string saved =
        run + "--checkpoint " + precision + ".h5 --checkpoint-every 0.05 ";
    const std::string whole = figures(result_of(run));
    int killed = 0;
    for (double seconds = 0.3; seconds < 100; seconds *= 1.5) {
      const Run cut = run_springcheck(
          saved, "timeout --foreground -s KILL " + std::to_string(seconds) + " ");
      if (cut.status == 0) break;
      ++killed;
      if (killed > 2 && fs::exists(folder / (precision + ".h5"))) break;
    }
    BOOST_TEST(killed > 0);
    BOOST_TEST(fs::exists(folder / (precision + ".h5")));
    const Run rest = run_springcheck(saved);
    BOOST_TEST(
        rest.err.find("going on from " + precision + ".h5 at t = ") != std::string::npos,
        rest.err);
    BOOST_TEST(figures(Json::parse(rest.out)["results"][0]) == whole);
    BOOST_TEST(files_named(precision) <= 2U);        // of the last kill, not of each
    BOOST_TEST(figures(result_of(saved)) == whole);  // again, from the last one saved
  }
}

BOOST_AUTO_TEST_CASE(a_checkpoint_belongs_to_one_case_in_dynamics) {
  const std::string saved =
      "run compression --method mss-cf --duration 0.2 --checkpoint case.h5 "
      "--checkpoint-every 0 ";
  BOOST_TEST(run_springcheck(saved + "--cells 4,4,4 --solver verlet").status == 0);
  const std::vector<std::pair<std::string, std::string>> changes{
      {"--cells 4,4,4 --solver semi-implicit",
       "expected solver = \"semi-implicit\", got solver = \"verlet\""},
      {"--cells 4,4,5 --solver verlet", "expected cells = [4,4,5], got cells = [4,4,4]"},
      {"--cells 4,4,4 --solver verlet --nu 0.3", "expected nu = 0.3, got nu = 0.25"},
      {"--cells 4,4,4 --solver verlet --deformation 6%", "expected deformation = 0.06"},
      {"--cells 4,4,4 --solver verlet --dt 1e-4", "expected dt = 0.0001"},
      {"--cells 4,4,4 --solver verlet --precision float", "expected precision = "},
      {"--cells 4,4,4 --solver verlet --history 3", "expected history = 3, got none"}};
  for (const auto& [change, message] : changes) expect_bad_input(saved + change, message);
  expect_bad_input(short_run + "--solver verlet --checkpoint same.h5 --out ./same.h5",
                   "another file than that of --out");
  expect_bad_input(pressed + "--method mss-cf --checkpoint static.h5",
                   "goes through time");
  expect_bad_input(pressed + "--solver verlet --method mss-cf,mss-fd --checkpoint two.h5",
                   "one method");
  for (const char* seconds : {"nan", "-1", "soon", "''"})
    expect_bad_input(short_run +
                         "--solver verlet --checkpoint new.h5 "
                         "--checkpoint-every " +
                         seconds,
                     "a number of seconds, 0 or more");
  expect_bad_input(short_run + "--solver verlet --checkpoint-every 5", "--checkpoint");
  for (const char* setting : {"--dt 1e-4", "--duration 1", "--damping 0.1",
                              "--precision float", "--force-dt", "--history 3"})
    expect_bad_input(pressed + "--method mss-cf " + setting,
                     "without a solver that goes through time");
  expect_bad_input(short_run + "--solver verlet --checkpoint nowhere/x.h5",
                   "nowhere/x.h5");
  expect_bad_input(short_run + "--solver verlet --checkpoint .", "a directory");
  std::ofstream(folder / "text.h5") << "no HDF5\n";
  expect_bad_input(short_run + "--solver verlet --checkpoint text.h5",
                   "a checkpoint of springcheck");
  BOOST_TEST(text_of(folder / "text.h5") == "no HDF5\n");
  BOOST_TEST(!fs::exists(folder / "static.h5"));
  BOOST_TEST(!fs::exists(folder / "two.h5"));
}

// What comes of it is neither's own, and nothing takes it for that.
BOOST_AUTO_TEST_CASE(a_run_goes_on_from_another_revision_as_both) {
  const std::string run =
      "run compression --method mss-cf --duration 0.2 --cells 2,2,2 "
      "--solver verlet --checkpoint both.h5 --checkpoint-every 0 ";
  const std::string own = json_of(run + "--json")["results"][0]["revision"];
  std::ofstream(folder / "both.py") << "import h5py\n"
                                       "with h5py.File('both.h5', 'r+') as file:\n"
                                       "    file.attrs['revision'] = '0123456789ab'\n";
  const std::string change = "cd " + folder.string() + " && /usr/bin/python3 both.py";
  BOOST_TEST_REQUIRE(std::system(change.c_str()) == 0);
  expect_bad_input(run, "checkpoint of another revision of the numerics");
  const std::string both = "0123456789ab+" + own;
  const Run accepted =
      run_springcheck(run + "--accept-other-revisions --out both-result.h5");
  BOOST_TEST(accepted.status == 0);
  BOOST_TEST(accepted.out.find(both) != std::string::npos, accepted.out);
  expect_bad_input("report both-result.h5 --out both", "1 of " + both);
}

// The file cannot hold what is to be saved: stderr says so, and the run goes on.
BOOST_AUTO_TEST_CASE(a_full_disk_for_the_checkpoint_does_not_lose_the_run) {
  // 10 kB hold what is printed, and not 729 nodes.
  const Run full = run_springcheck(
      "run compression --cells 8,8,8 --json --method mss-cf --solver verlet --dt 1e-3 "
      "--duration 0.02 --checkpoint full.h5 --checkpoint-every 0",
      "ulimit -f 20 && ");
  BOOST_TEST(full.status == 0);
  BOOST_TEST(full.err.find("no checkpoint at") != std::string::npos, full.err);
  BOOST_TEST(files_named("full") == 0U);
  BOOST_TEST(Json::parse(full.out)["results"][0]["status"] == "ok");
}

BOOST_AUTO_TEST_SUITE_END()
