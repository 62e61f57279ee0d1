#include "tests/cli/program.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>

BOOST_AUTO_TEST_SUITE(dynamics_cli_test)

namespace {

const std::string pressed = "run compression --cells 4,4,4 --json ";
const std::string short_run = pressed + "--method mss-cf --duration 0.2 ";

Json result_of(const std::string& arguments) {
  return json_of(arguments)["results"][0];
}

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

// All ways through time end near each other: the load has grown over 100 swings of a
// cell.
BOOST_AUTO_TEST_CASE(every_solver_goes_by_its_name) {
  const std::string run = short_run + "--damping 0.2 --dt ";
  const Json semi = result_of(run + "1e-4 --solver semi-implicit");
  for (const auto& [solver, dt] : {std::pair("explicit", "1e-4"),
                                   {"semi-implicit", "auto"},
                                   {"verlet", "auto"},
                                   {"implicit", "5e-4"}}) {
    const Json result = result_of(run + dt + " --solver " + solver);
    BOOST_TEST(result["solver"] == solver);
    BOOST_TEST(result["status"] == "ok", result["reason"]);
    BOOST_TEST(result["steps"].get<int>() > 0);
    BOOST_TEST(result["dt_limit"].is_null() == (result["solver"] == "implicit"));
    BOOST_TEST(result["plate_force"].get<double>() == semi["plate_force"].get<double>(),
               boost::test_tools::tolerance(0.01));
  }
}

// The way to half of the load is slow and damped: it ends near rest there, which a finer
// law would not be within 5 % of (measured: .1 and 1 %).
BOOST_AUTO_TEST_CASE(a_motion_that_ends_early_is_compared_there) {
  const std::string sheared =
      "run shearing --cells 4,4,4 --deformation 10% --damping .3 --solver verlet ";
  const std::string half = sheared + "--load-times 2 --load-fractions 0.5 --method ";
  const Run told = run_springcheck(half + "mss-cf,fem-stvk");
  BOOST_TEST(told.out.find("The load ends at 50 % of the whole one") !=
             std::string::npos);
  const Json results = json_of(half + "mss-cf,fem-stvk --json")["results"];
  BOOST_TEST(results[0]["deviation_l2_relative"].get<double>() < 0.05);
  BOOST_TEST(results[1]["deformation"] == 0.05);
  const Json own = result_of(half + "mss-cf --reference mss-cf:static --json");
  BOOST_TEST(own["reference"] == "mss-cf:static");
  BOOST_TEST(own["deviation_l2_relative"].get<double>() < 0.005);
  const Json unloaded =
      result_of(sheared + "--load-times 1,2 --load-fractions 1,0 --method mss-cf --json");
  BOOST_TEST(unloaded["reference"].is_null());
  BOOST_TEST(unloaded["reason"] ==
             "the load ends at 0: no deviation from bodies at rest");
}

// Two layers of cells can go through themselves: nothing that bends holds them apart.
BOOST_AUTO_TEST_CASE(a_motion_that_lost_its_turn_went_through_itself) {
  const auto result = [](const std::string& turn) -> Json {
    const Run run = run_springcheck(
        "run torsion --cells 2,2,2 --method mss-cf --solver verlet --damping 0.5 "
        "--duration 4 --json --deformation " +
        turn);
    return Json::parse(run.out)["results"][0];
  };
  const Json lost = result("300deg");
  BOOST_TEST(lost["status"] == "inverted");
  BOOST_TEST(lost["reason"].get<std::string>().starts_with(
                 "the body went through itself: it is turned by -60 degrees, its plates "
                 "by 300"),
             lost["reason"]);
  BOOST_TEST(result("100deg")["status"] == "ok");
}

// A traction's force grows with its load, on the way and at the end.
BOOST_AUTO_TEST_CASE(a_traction_at_part_of_its_load) {
  const std::string pulled =
      "run traction --cells 3,3,3 --method mss-cf --solver verlet --damping 1 --json ";
  const Json whole = result_of(pulled + "--duration 4 --history 4");
  const double force = whole["plate_force"];
  for (std::size_t i = 0; i < 4; ++i)
    BOOST_TEST(whole["history"]["force_z"][i].get<double>() ==
                   force * whole["history"]["load_fraction"][i].get<double>(),
               boost::test_tools::tolerance(1e-9));
  const Json half = result_of(pulled + "--load-times 4 --load-fractions 0.5");
  BOOST_TEST(half["plate_force"].get<double>() == force / 2,
             boost::test_tools::tolerance(1e-9));
}

// The bound is 1e-5 of the deformations' size, as in march_test.
BOOST_AUTO_TEST_CASE(single_precision_is_near_double_and_not_it) {
  const std::string run = pressed + "--duration 0.2 --solver semi-implicit --method ";
  const Json fine = result_of(run + "mss-cf"),
             rough = result_of(run + "mss-cf --precision float");
  BOOST_TEST(rough["status"] == "ok");
  BOOST_TEST(rough["plate_force"] != fine["plate_force"]);
  BOOST_TEST(rough["plate_force"].get<double>() == fine["plate_force"].get<double>(),
             boost::test_tools::tolerance(1e-4));
  const Run refused =
      run_springcheck(run + "mss-affine --cell-type tetrahedron --precision float");
  BOOST_TEST(refused.status == 3);
  BOOST_TEST(Json::parse(refused.out)["results"][0]["status"] == "refused");
}

BOOST_AUTO_TEST_CASE(the_history_is_in_the_json_and_in_the_result_file) {
  const Json result =
      result_of(short_run + "--solver verlet --damping 0.2 --history 5 --out history.h5");
  const Json& history = result["history"];
  for (const char* column :
       {"time", "load_fraction", "deformation", "volume_change", "force_x", "force_z",
        "torque_z", "kinetic_energy", "strain_energy"})
    BOOST_TEST(history[column].size() == 5U, column);
  BOOST_TEST(history["time"][4] == 0.2);
  BOOST_TEST(history["deformation"][4] == 0.05);
  BOOST_TEST(history["force_z"][4] == result["force"][2]);
  BOOST_TEST(history["kinetic_energy"][4] == result["kinetic_energy"]);
  std::ofstream(folder / "read.py")
      << "import h5py, json\n"
         "tables = []\n"
         "def visit(name, item):\n"
         "    if name.startswith('fields/') and name.endswith('/history'): "
         "tables.append([[None if x != x else x for x in row] for row in "
         "item[...].tolist()])\n"
         "h5py.File('history.h5').visititems(visit)\n"
         "print(json.dumps(tables))\n";
  const std::string command =
      "cd " + folder.string() + " && /usr/bin/python3 read.py >read.json";
  BOOST_TEST_REQUIRE(std::system(command.c_str()) == 0);
  const Json tables = Json::parse(text_of(folder / "read.json"));
  BOOST_TEST_REQUIRE(tables.size() == 1U);
  BOOST_TEST_REQUIRE(tables[0].size() == 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    BOOST_TEST(tables[0][i].size() == history.size());
    BOOST_TEST(tables[0][i][0] == history["time"][i]);
    BOOST_TEST(tables[0][i][6] == history["force_z"][i]);
    BOOST_TEST(tables[0][i][11] == history["strain_energy"][i]);
    BOOST_TEST(tables[0][i][20].is_null());  // no mean stress but in affine
  }
}

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

BOOST_AUTO_TEST_CASE(a_step_above_the_limit_is_refused_with_what_sets_it) {
  for (const char* solver : {"explicit", "semi-implicit", "verlet"}) {
    const std::string run = short_run + "--nu 0.4 --dt 0.01 --solver " + solver + " ";
    const Run refused = run_springcheck(run);
    BOOST_TEST(refused.status == 3);
    const Json result = Json::parse(refused.out)["results"][0];
    const std::string reason = result["reason"];
    for (const char* part : {"dt = 0.01 s", "stability limit", "nu = 0.4",
                             "cells of 0.0125 m", "damping ratio of 0.05"})
      BOOST_TEST(reason.find(part) != std::string::npos, reason);
    BOOST_TEST(result["dt_limit"].get<double>() < 0.01);
    const Run forced = run_springcheck(run + "--force-dt");
    BOOST_TEST(forced.status == 3);
    const Json broken = Json::parse(forced.out)["results"][0];
    BOOST_TEST(broken["status"] == "diverged");
    BOOST_TEST(broken["volume_error"].is_null());
    BOOST_TEST(
        broken["reason"].get<std::string>().find(
            "by step " + std::to_string(broken["steps"].get<int>())) != std::string::npos,
        broken["reason"]);
  }
}

// With the limit at rest kept, these runs end diverged by step 800 of 886 or before.
BOOST_AUTO_TEST_CASE(an_open_step_follows_the_limit_near_nu_one_half,
                     *boost::unit_test::label("slow")) {
  for (const char* run :
       {"run compression --method mss-cf --nu .49 --deformation 20% --duration .28 ",
        "run torsion --method fem-explicit-8p --nu .499 --deformation 90deg "
        "--duration .09 "}) {
    const Json result = result_of(run + std::string("--solver semi-implicit --json"));
    // At 90 degrees elements of eight points have a corner turned inside out.
    BOOST_TEST((result["status"] == "ok" || result["status"] == "inverted"),
               result["reason"]);
    BOOST_TEST(result["dt"].get<double>() < result["dt_limit"].get<double>());
  }
}

BOOST_AUTO_TEST_CASE(what_explicit_euler_leaves_undamped_is_named) {
  const std::string run = pressed + "--duration .01 --solver explicit --method ";
  for (const auto& [method, cause] :
       {std::pair("mss-affine", "dashpots along the cells' edges"),
        {"mss-affine --dt 1e-5", "dashpots along the cells' edges"},
        {"mss-cf --damping 0", "without dashpots"}}) {
    const Run refused = run_springcheck(run + method);
    BOOST_TEST(refused.status == 3);
    const std::string reason = Json::parse(refused.out)["results"][0]["reason"];
    BOOST_TEST(reason.find(cause) != std::string::npos, reason);
    BOOST_TEST(reason.find("semi-implicit and verlet") != std::string::npos, reason);
    BOOST_TEST(reason.find("limit 0 s") == std::string::npos, reason);
  }
}

BOOST_AUTO_TEST_SUITE_END()
