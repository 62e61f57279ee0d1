#include "tests/cli/program.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(stability_cli_test)

namespace {

const std::string stability = "stability compression --cells 3,3,3 ";

}  // namespace

BOOST_AUTO_TEST_CASE(a_map_and_its_limits_are_printed) {
  const Run run = run_springcheck(
      stability + "--method mss-cf,mss-nfd --over deformation=2%:20%:2 --over nu=0,0.25");
  BOOST_TEST(run.status == 0, run.err);
  for (const char* part : {"mss-cf: deformation against nu", "mss-nfd: deformation",
                           "holds at [%]", "wrinkling", "12 simulations computed"})
    BOOST_TEST(run.out.find(part) != std::string::npos, run.out);
}

// Half of a load for one method and all of it for another is no map.
BOOST_AUTO_TEST_CASE(paths_that_end_early_have_no_map_beside_bodies_at_rest) {
  const std::string path =
      "--load-times 1 --load-fractions 0.5 --over deformation=2%,4% --method ";
  const Run mixed = run_springcheck(stability + path + "fem-explicit-1p,mss-cf");
  BOOST_TEST(mixed.status == 2);
  BOOST_TEST(mixed.err.find("expected a path that ends with the whole load") !=
                 std::string::npos,
             mixed.err);
  BOOST_TEST(run_springcheck(stability + path + "fem-explicit-1p").status == 0);
}

BOOST_AUTO_TEST_CASE(settings_named_without_values_go_over_usual_ones,
                     *boost::unit_test::label("slow")) {
  const Run run =
      run_springcheck(stability + "--method mss-nfd --over deformation,nu --format csv");
  BOOST_TEST(run.status == 0, run.err);
  for (const char* row : {"mss-nfd,5%,0,", "mss-nfd,60%,0.499,"})
    BOOST_TEST(run.out.find(row) != std::string::npos, run.out);
}

BOOST_AUTO_TEST_CASE(points_and_limits_are_rows_of_other_formats) {
  const Run run = run_springcheck(
      stability + "--method mss-nfd --over deformation=2%:20%:2 --format csv");
  BOOST_TEST(run.status == 0, run.err);
  BOOST_TEST(run.out.find("method,deformation,failure,status") != std::string::npos,
             run.out);
  BOOST_TEST(run.out.find("mss-nfd,20%,") != std::string::npos, run.out);
}

// A page is made of it too: no path ends there.
BOOST_AUTO_TEST_CASE(an_atlas_in_which_everything_holds_has_a_page) {
  BOOST_TEST(run_springcheck(stability +
                             "--method mss-cf --over deformation=5%:20%:2 --over "
                             "nu=.1,.25,.4 --out hold.h5")
                 .status == 0);
  BOOST_TEST(run_springcheck("report hold.h5 --out hold").status == 0);
}

// Pressed bodies fail at the lower end of the axis.
BOOST_AUTO_TEST_CASE(limits_along_negative_strains_are_bisected_with_their_sign) {
  const Json tables = json_of(
      "stability uniaxial --cells 3,3,3 --method mss-cf --over deformation=-0.6:-0.1:6 "
      "--format json");
  const Json limit = tables[1]["rows"][0];
  const double holds = limit["holds"], fails = limit["fails"];
  BOOST_TEST(holds > -0.4);
  BOOST_TEST(holds < -0.3);
  BOOST_TEST(fails < holds);
  BOOST_TEST(fails > 1.011 * holds);
}

BOOST_AUTO_TEST_CASE(locking_is_judged_between_the_points_too) {
  const Json tables = json_of(
      "stability compression --cells 3,3,3 --method fem-hooke --element q1 --deformation "
      "10% --over nu=.3,.49 --locking --format json");
  const Json limit = tables[1]["rows"][0];
  BOOST_TEST(limit["failure"] == "locking");
  const double holds = limit["holds"], fails = limit["fails"];
  BOOST_TEST(holds >= 0.3);
  BOOST_TEST(fails < 0.48);
  BOOST_TEST(fails - holds <= 0.01 * fails);
}

// With next to no face diagonals mss-cf wrinkles, at 2.42 % on 10^3 cells. The limit
// printed of a path is as wide as the path was followed, whatever the axis.
BOOST_AUTO_TEST_CASE(a_paths_limit_is_known_to_its_resolution) {
  const Json tables = json_of(
      "stability compression --cells 4,4,4 --method mss-cf --diagonal-ratio .01 --nu "
      "0.25 "
      "--over deformation=10%:60%:2 --format json");
  const Json limit = tables[1]["rows"][0];
  BOOST_TEST(limit["failure"] == "wrinkling");
  BOOST_TEST(limit["wavelength"].get<double>() < 3);
  const double holds = limit["holds"], fails = limit["fails"];
  BOOST_TEST(holds < fails);
  BOOST_TEST(fails <= 1.0021 * holds);
}

BOOST_AUTO_TEST_CASE(steps_above_the_limit_are_run_where_they_are_the_axis) {
  const Json tables = json_of(
      stability +
      "--method mss-cf --solver verlet --duration .5 --over dt=.003:.01:2 --format json");
  BOOST_TEST(tables[0]["rows"][1]["failure"] == "blow-up");
  BOOST_TEST(tables[1]["rows"][0]["failure"] == "blow-up");
}

// Seeds have none between them, a mesh's tolerance is no limit of the body, and labels
// that hold the axis leave holes.
BOOST_AUTO_TEST_CASE(what_has_no_limits_says_so) {
  const Run seeds = run_springcheck(
      stability +
      "--method fem-stvk --distortion .25 --deformation 28% --over seed=1,2,3");
  BOOST_TEST(seeds.status == 0, seeds.err);
  BOOST_TEST(seeds.out.find("holds at") == std::string::npos, seeds.out);
  const Run refused = run_springcheck(
      stability + "--method mss-cf --over distortion=0:0.2:3 --format csv");
  BOOST_TEST(refused.out.find("mss-cf,0,none,not covered") != std::string::npos,
             refused.out);
  const Run elements =
      run_springcheck(stability + "--method fem-hooke --over element=q1,q1-sri,q2");
  BOOST_TEST(elements.status == 0, elements.err);
}

// What a killed atlas left is not computed again, and the page shows the limits.
BOOST_AUTO_TEST_CASE(an_atlas_is_kept_in_its_file) {
  const std::string atlas =
      stability +
      "--method mss-cf,mss-nfd --over deformation=2%:40%:4 --over nu=0:0.4:3 --out "
      "atlas.h5";
  run_springcheck(atlas, "timeout --foreground -s KILL 0.5 ");
  const Run resumed = run_springcheck(atlas);
  BOOST_TEST(resumed.status == 0, resumed.err);
  const Run again = run_springcheck(atlas);
  BOOST_TEST(again.out.find("\n0 simulations computed, 24 points") != std::string::npos,
             again.out);
  BOOST_TEST(run_springcheck("report atlas.h5 --out page").status == 0);
  const std::string page = text_of(folder / "page" / "index.html");
  BOOST_TEST(page.find("Limits of stability") != std::string::npos);
  BOOST_TEST(fs::exists(folder / "page" / "figures" / "limits_compression.svg"));
}

BOOST_AUTO_TEST_CASE(a_limit_is_a_case_without_measures) {
  const Json result = json_of(
      "run compression --cells 4,4,4 --nu 0 --deformation 20% --solver limit --method "
      "mss-nfd --json")["results"][0];
  BOOST_TEST(result["status"] == "indefinite");
  BOOST_TEST(result["volume_error"].is_null());
  BOOST_TEST(result["critical_wavelength"].get<double>() < 4);
  const double limit = result["definite_up_to_deformation"].get<double>();
  // Above the limit mss-nfd wrinkles, below it does not.
  const auto status_at = [](double strain) {
    return json_of(
        "run compression --cells 4,4,4 --nu 0 --method mss-nfd --json "
        "--noise 0.01 --deformation " +
        std::to_string(strain))["results"][0]["status"];
  };
  BOOST_TEST(status_at(.9 * limit) == "ok");
  BOOST_TEST(status_at(1.5 * limit) != "ok");
}

BOOST_AUTO_TEST_CASE(what_cannot_be_mapped_is_refused) {
  expect_bad_input(stability + "--over nu=0:1", "FROM:TO:COUNT");
  expect_bad_input(stability + "--over mu=0:1:3", "'mu'");
  expect_bad_input(stability + "--over method=mss-cf,mss-nfd", "method");
  expect_bad_input(stability + "--over nu=0,0.2 --over nu=0,0.2", "twice");
  expect_bad_input(stability + "--over nu=0,0.6", "0.5");
  expect_bad_input(
      stability + "--over nu=0,0.2 --over deformation=1%,2% --over young=1e3,1e4",
      "one or two");
  expect_bad_input(stability, "--over");
  expect_bad_input(stability + "--over young", "KEY=FROM:TO:COUNT");
  expect_bad_input(stability + "--method mss-cf --over dt-ratio", "changes no case");
  expect_bad_input(stability + "--method mss-cf --over element=q1,q2", "changes no case");
  expect_bad_input(stability + "--over nu,deformation,distortion", "one or two");
}

BOOST_AUTO_TEST_SUITE_END()
