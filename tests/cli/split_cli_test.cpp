#include "tests/cli/program.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(split_cli_test)

// Springs that are compared at rest with the end of a motion without a load have no load
// either.
BOOST_AUTO_TEST_CASE(without_a_load_there_is_nothing_to_split) {
  const Run run = run_springcheck(
      "run shearing --cells 2,2,2 --method mss-cf,fem-explicit-1p --load-times 1,2 "
      "--load-fractions 1,0 --split");
  BOOST_TEST(run.status == 2);
  BOOST_TEST(run.err.find("expected a load at the end of the path") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(split_is_an_object_for_springs_and_null_for_finite_elements) {
  const Json json = json_of(
      "run shearing --method mss-cf,fem-stvk --cells 2,2,2 --split --out split.h5 "
      "--json");
  const Json& split = json["results"][0]["split"];
  BOOST_TEST(json["results"][1]["split"].is_null());
  BOOST_TEST(split["reference"] == "fem-hencky:q1-sri");
  for (const char* name : {"volume_change", "plate_force_norm", "mean_deviation"}) {
    const Json& quantity = split["quantities"][name];
    for (const char* key :
         {"springs", "cauchy_born", "reference", "law", "discretisation", "resolved"})
      BOOST_TEST(quantity.contains(key), name << " " << key);
    for (const char* key :
         {"value", "order", "bar", "grids", "check", "disagreement", "resolved"})
      BOOST_TEST(quantity["cauchy_born"].contains(key), name << " " << key);
    BOOST_TEST(quantity["cauchy_born"]["grids"].size() == 3U);
  }
  // The grids are cases of the result file.
  const std::string key =
      split["quantities"]["volume_change"]["reference"]["grids"][2]["key"];
  BOOST_TEST(text_of(folder / "split.h5").find(key) != std::string::npos);
  // Without --split the result has no split.
  BOOST_TEST(
      json_of("run shearing --method mss-cf --cells 2,2,2 --json")["results"][0]["split"]
          .is_null());
  // Springs in squared lengths follow St-Venant and Kirchhoff's law: nothing is left of
  // the law's part but rounding of forces of 4 N.
  const Json squared = json_of(
      "run compression --method mss-stvk --cells 2,2,2 --deformation 20% --split "
      "--json")["results"][0]["split"];
  BOOST_TEST(squared["reference"] == "fem-stvk:q1-sri");
  const double law_part = squared["quantities"]["plate_force"]["law"]["value"];
  BOOST_TEST(std::abs(law_part) < 1e-11);
  expect_bad_input("run shearing --method mss-cf --split --reference mss-fd",
                   "a law of finite elements");
  expect_bad_input("run shearing --method mss-cf --split --reference fem-stvk:q2",
                   "a method alone with --split");
  expect_bad_input("run shearing --method mss-cf --split --reference fem-stvk@converged",
                   "a method alone with --split");
  expect_bad_input("run shearing --method fem-stvk --split", "at least one of springs");
  expect_bad_input("run shearing --method mss-cf --split --solver semi-implicit",
                   "expected static");
}

BOOST_AUTO_TEST_CASE(references_on_other_grids_are_named_with_theirs) {
  const auto reference = [](const std::string& grid) {
    return json_of(
               "run shearing --method mss-cf --cells 2,2,2 --json --reference "
               "fem-hencky" +
               grid)["results"][0]["reference"]
        .get<std::string>();
  };
  BOOST_TEST(reference("") == "fem-hencky:q1-sri");
  BOOST_TEST(reference(":q2@4") == "fem-hencky:q2@4,4,4");
  BOOST_TEST(reference("@4,4,2") == "fem-hencky:q1-sri@4,4,2");
  BOOST_TEST(reference("@converged") == "fem-hencky:q1-sri@converged");
  expect_bad_input("run shearing --method mss-cf --cells 2,2,2 --reference fem-hencky@3",
                   "a whole multiple of the first of the case's 2,2,2, got 3");
  expect_bad_input("table elements --reference fem-hencky", "no reference");
}

BOOST_AUTO_TEST_SUITE_END()
