#include "tests/cli/program.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>

BOOST_AUTO_TEST_SUITE(tissue_cli_test)

namespace {

const std::string small = "run tissue-shearing --cells 2,2,2 ";

Json result_of(const std::string& options) {
  const Run run = run_springcheck(small + options + " --json");
  BOOST_TEST(run.status == 0, run.err);
  return Json::parse(run.out)["results"][0];
}

/// The law's stress at a strain of 1 [Pa], by the table of tissue.
double law_of(const std::string& organ, double rate) {
  static const Json rows = json_of("table tissue --format json")["rows"];
  for (const Json& row : rows)
    if (row["organ"] == organ && row["rate"] == rate && row["strain"] == 1)
      return row["law"];
  BOOST_FAIL("no row of " + organ);
  return 0;
}

}  // namespace

// Within the fitted branches' 2 %.
BOOST_AUTO_TEST_CASE(sheared_organs_have_the_laws_stress) {
  for (const char* organ : {"liver", "kidney", "spleen"})
    for (const double rate : {0.0151, 0.67}) {
      const Json result =
          result_of(std::string("--organ ") + organ + " --rate " + std::to_string(rate));
      const double stress = result["mean_stress"][0][2];
      BOOST_TEST(stress == law_of(organ, rate), boost::test_tools::tolerance(0.02));
      BOOST_TEST(result["young"].is_null());
      BOOST_TEST(result["reason"].is_null());
    }
}

BOOST_AUTO_TEST_CASE(a_law_of_ones_own_is_the_organs_of_the_same_numbers) {
  const std::string scene = text_of("comparisons/shipped/scenes/tissue-shearing.toml");
  const std::string organ = "organ = \"spleen\"";
  std::string own = scene;
  own.replace(own.find(organ), organ.size(), "law = [861, 0.1138, 0.40, 4.17]");
  std::ofstream(folder / "own.toml") << own;
  const Json a = json_of("run ./own.toml --cells 2,2,2 --json")["results"][0],
             b = result_of("--organ liver");
  BOOST_TEST(a["mean_stress"].dump() == b["mean_stress"].dump());
}

BOOST_AUTO_TEST_CASE(a_held_shear_has_a_history_and_a_place_in_result_files) {
  const Json result =
      result_of("--load-times 7.5,17.5 --load-fractions 1,1 --history 4 --out held.h5");
  BOOST_TEST(result["history"]["time"].size() == 8U);
  BOOST_TEST(result["history"]["load_fraction"].back() == 1);
  const std::vector<double> energy = result["history"]["strain_energy"];
  BOOST_TEST(energy[3] > energy[7]);  // it relaxes
  BOOST_TEST(run_springcheck("report held.h5 --out page").status == 0);
}

// The stress is that of the strain a quarter of a cycle before it, in part: it is largest
// before the strain is.
BOOST_AUTO_TEST_CASE(an_oscillation_has_the_stress_on_its_way) {
  const Json result = json_of("run tissue-oscillation --cycles 2 --json")["results"][0];
  const std::vector<double> stress = result["history"]["stress_xz"],
                            load = result["history"]["load_fraction"];
  BOOST_TEST_REQUIRE(stress.size() == 128U);
  BOOST_TEST(load[79] == 1, boost::test_tools::tolerance(1e-12));
  const auto largest = std::max_element(stress.begin() + 64, stress.end());
  BOOST_TEST((largest - stress.begin()) < 79);
  BOOST_TEST(*largest > stress[79]);
  BOOST_TEST(result["mean_stress"][0][2] == stress.back());
}

// As the table has it, which needs no simulation for it: in cells of 5 mm.
BOOST_AUTO_TEST_CASE(the_thesiss_springs_run_as_the_table_has_them) {
  const Json rows = json_of("table tissue --format json")["rows"];
  int found = 0;
  for (const auto& [method, column] :
       {std::pair{"mss-thesis-tissue", "thesis"},
        std::pair{"mss-thesis-tissue-relative", "repaired"}}) {
    const Json result =
        json_of(std::string("run tissue-shearing --json --time-steps 5 --cells 10,10,10 "
                            "--organ liver --method ") +
                method)["results"][0];
    const double stress = result["mean_stress"][0][2];
    for (const Json& row : rows) {
      if (row["organ"] != "liver" || row["strain"] != 1) continue;
      BOOST_TEST(row[column].get<double>() == stress, boost::test_tools::tolerance(1e-6));
      ++found;
    }
  }
  BOOST_TEST(found == 6);  // two methods at three rates
  const Run other = run_springcheck(
      "run tissue-shearing --cells 2,2,2 --method mss-thesis-tissue --law 900,.1,.3,4");
  BOOST_TEST(other.out.find("to liver, kidney and spleen alone") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(strains_beyond_the_fit_are_flagged) {
  const std::string far = "--gradient 0,0,1.4,0,0,0,0,0,0";
  const Json result = result_of(far);
  BOOST_TEST(result["status"] == "ok");
  BOOST_TEST(result["flags"] == Json::array({"extrapolated"}));
  BOOST_TEST(std::string(result["reason"]).find("extrapolated") == 0U);
  BOOST_TEST(result_of("")["flags"] == Json::array());
  BOOST_TEST(run_springcheck(small + far).out.find("ok, extrapolated") !=
             std::string::npos);
  std::ofstream(folder / "flag.toml") << "test = \"compression\"\nmethod = \"mss-cf\"\n"
                                         "expect = \"extrapolated\"\n";
  expect_bad_input("run ./flag.toml",
                   "how a case ends (extrapolated is a flag beside that)");
}

BOOST_AUTO_TEST_CASE(result_files_and_pages_keep_the_flag) {
  result_of("--gradient 0,0,1.4,0,0,0,0,0,0 --out far.h5");
  const Run page = run_springcheck("report far.h5 --out far");
  BOOST_TEST(page.status == 0, page.err);
  const std::string html = text_of(folder / "far/index.html");
  BOOST_TEST(html.find("Flagged as extrapolated") != std::string::npos);
  BOOST_TEST(html.find("shear strains of 1.4 (fitted to 1)") != std::string::npos);
}

// The faces' bulging strains cells 2.8 times as fast as the plates go: up to 27 1/s here.
// A force that goes with the rate to the n = .1138, within a fifth.
BOOST_AUTO_TEST_CASE(fast_compression_stays_near_the_law) {
  const auto force = [](double rate) {
    const Json result = json_of(
        "run tissue-compression --method mss-tissue --organ liver --cells 3,3,3 "
        "--deformation 30% --json --rate " +
        std::to_string(rate))["results"][0];
    BOOST_TEST(result["status"] == "ok");
    return result["plate_force"].get<double>();
  };
  const double slow = force(0.133);
  for (const double rate : {0.5, 2., 4., 10.})
    BOOST_TEST(force(rate) == slow * std::pow(rate / 0.133, 0.1138),
               boost::test_tools::tolerance(0.2));
}

BOOST_AUTO_TEST_CASE(large_compression_converges_with_any_number_of_branches) {
  for (const char* branches : {"4", "6", "8", "12"}) {
    const Json result =
        json_of(std::string("run tissue-compression --method mss-tissue --organ liver "
                            "--rate .133 --cells 3,3,3 --deformation 40% --json "
                            "--branches ") +
                branches)["results"][0];
    BOOST_TEST(result["status"] == "ok", branches << ": " << result["reason"]);
  }
}

// A column ten times as long as wide buckles, springs and elements alike.
BOOST_AUTO_TEST_CASE(a_column_s_loss_of_stability_is_told) {
  for (const Json& result :
       json_of("run tissue-compression --organ liver --cells 1,1,10 --size .01,.01,.1 "
               "--json")["results"]) {
    BOOST_TEST(result["status"] == "ok");
    BOOST_TEST(std::string(result["reason"]).starts_with("the tangent is not positive"));
    BOOST_TEST(result["definite_up_to_deformation"] < 0.065);
  }
}

// Steps so short that in none of them the tissue gives way: to a long step, 1 % of
// strain.
BOOST_AUTO_TEST_CASE(stability_is_judged_alike_in_steps_of_any_length,
                     *boost::unit_test::label("slow")) {
  const auto definite_up_to = [](const std::string& steps) -> double {
    const Json result = json_of(
        "run tissue-compression --organ liver --method mss-tissue --cells 2,2,20 "
        "--size .01,.01,.1 --json --time-steps " +
        steps)["results"][0];
    BOOST_TEST_REQUIRE(result["definite_up_to_deformation"].is_number());
    return result["definite_up_to_deformation"];
  };
  const double found = definite_up_to("20"), other = definite_up_to("1000");
  BOOST_TEST(found > 0.035);
  BOOST_TEST(other >= found);
  BOOST_TEST(other < found + 0.01);
}

// Swinging loads harden less by the branches than by the law: the liver's are off by a
// third of its stress there, the spleen's by less than a tenth.
BOOST_AUTO_TEST_CASE(poor_paths_of_the_load_are_told) {
  const auto reason = [](const std::string& organ) -> Json {
    const Json run = json_of(
        "run tissue-oscillation --angular-frequency 1 --cycles 3 --gradient "
        "0,0,0.5,0,0,0,0,0,0 --organ " +
        organ + " --json");
    return run["results"][0]["reason"];
  };
  BOOST_TEST(reason("liver").get<std::string>().find(
                 "on this path of the load the branches are off the law "
                 "by up to 35 % of its largest stress") != std::string::npos);
  BOOST_TEST(reason("spleen").is_null());
}

BOOST_AUTO_TEST_CASE(poor_fits_are_told) {
  const std::string reason = result_of("--branches 2")["reason"];
  BOOST_TEST(
      reason.find("2 branches are off the law by up to 8.5 % in the fitted range") !=
          std::string::npos,
      reason);
}

BOOST_AUTO_TEST_CASE(bad_input_names_what_was_expected) {
  const auto refused = [](const std::string& options, const std::string& expected) {
    expect_bad_input(small + options, expected);
  };
  refused("--organ brain", "liver, kidney, spleen");
  refused("--organ liver --law 1,.1,.2,.3", "no value beside that of --organ");
  refused("--rate 0", "positive");
  refused("--rate -1", "positive");
  refused("--rate 1 --duration 2", "no value beside that of --duration");
  refused("--load-times 1,2", "load-fractions beside load-times");
  refused("--load-fractions 1", "no load-fractions without load-times");
  refused("--load-times 2,1 --load-fractions 1,1", "ascending");
  refused("--load-times -1,1 --load-fractions 1,1", "above 0");
  refused("--load-times 1 --load-fractions 1,1", "a fraction for each of 1 times");
  refused("--load-times 1 --load-fractions 0", "not all 0");
  refused("--cycles 2", "no cycles without angular-frequency");
  refused("--angular-frequency 0", "positive");
  refused("--angular-frequency 1 --cycles 0", "[0.01, 1000]");
  refused("--angular-frequency 1 --cycles 1001", "[0.01, 1000]");
  refused("--angular-frequency 1 --gradient 0,0,0,0,0,0,0,0,1",
          "turns the body inside out");
  expect_bad_input("run tissue-tension --deformation 1 --angular-frequency 1",
                   "presses the plates through each other");
  refused("--angular-frequency 1 --rate 1", "no value beside that of --rate");
  refused("--branches 1", "[2, 32]");
  refused("--time-steps 0", "[1, 1000000]");
  expect_bad_input("run compression --organ spleen", "no organ without mss-tissue");
  refused("--method mss-thesis-tissue --branches 3", "no branches without mss-tissue");
  expect_bad_input("run compression --method mss-tissue", "K,n,GAMMA_LIM,p");
  for (const char* law :
       {"0,.1,.2,.3", "1,0,.2,.3", "1,1,.2,.3", "1,.1,0,.3", "1,.1,.2,0"})
    expect_bad_input(std::string("run compression --method mss-tissue --law ") + law,
                     "n between 0 and 1");
}

BOOST_AUTO_TEST_SUITE_END()
