#include "tests/cli/program.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>

BOOST_AUTO_TEST_SUITE(table_cli_test)

BOOST_AUTO_TEST_CASE(a_table_s_cases_can_be_written_and_taken_again) {
  const Run first = run_springcheck("table orientation --out orientation.h5");
  BOOST_TEST(first.status == 0);
  const Run again =
      run_springcheck("table orientation --from orientation.h5 --out two.h5");
  BOOST_TEST(again.out == first.out);
  BOOST_TEST(fs::file_size(folder / "two.h5") > 0U);
  // Nothing is computed again: the solution times stay.
  run_springcheck("export orientation.h5 --out before.csv");
  BOOST_TEST(run_springcheck("table orientation --out orientation.h5").out == first.out);
  run_springcheck("export orientation.h5 --out after.csv");
  BOOST_TEST(!text_of(folder / "before.csv").empty());
  BOOST_TEST(text_of(folder / "after.csv") == text_of(folder / "before.csv"));
}

// The frequencies of the cube at nu = .25 are given to the digits of the other tests'
// oracle, Rayleigh and Ritz; that springs differ is what the table is for.
BOOST_AUTO_TEST_CASE(the_table_of_modes_needs_no_simulation,
                     *boost::unit_test::label("slow")) {
  const Json table = json_of("table modes --format json");
  BOOST_TEST(table["table"] == "modes");
  std::set<double> ratios;
  for (const Json& row : table["rows"]) {
    ratios.insert(row["nu"].get<double>());
    BOOST_TEST(row["cases"].empty());
    for (const char* method : {"fem", "lumped", "nodal", "affine"})
      BOOST_TEST(row[method].get<double>() > 0, method);
    if (row["body"] == "free cube of tetrahedra") {  // weak modes are what it is there for
      BOOST_TEST(row["status"] == "mss-cf refused, mss-nfd refused");
      BOOST_TEST(row["notes"].dump().find("nodal FEM has 9") != std::string::npos);
      continue;
    }
    BOOST_TEST(row["status"] == "ok");
    BOOST_TEST(row["mac"].get<double>() > 0.9);
    for (const char* method : {"cf", "nfd"})
      BOOST_TEST(row[method].get<double>() > 0, method);
  }
  BOOST_TEST(ratios.size() == 4U);
  const auto find = [&](const std::string& body, double nu, const std::string& modes) {
    for (const Json& row : table["rows"])
      if (row["body"] == body && row["nu"] == nu && row["modes"] == modes) return row;
    return Json();
  };
  const Json cube = find("free cube", 0.25, "1-2");  // recorded
  BOOST_TEST(std::abs(cube["theory"].get<double>() - 18.1815) < 1e-3);
  BOOST_TEST(std::abs(cube["fem"].get<double>() - 18.356) < 1e-3);
  const double fem = cube["fem"], springs = cube["cf"];
  BOOST_TEST(std::abs(cube["cf_off"].get<double>() - 100 * (springs / fem - 1)) < 1e-9);
  BOOST_TEST(cube["notes"].size() == 2U);  // mss-nfd's zero and strange modes
  BOOST_TEST(find("cantilever", 0.25, "3")["motion"] == "torsion 1");
  BOOST_TEST(run_springcheck("table modes --reference fem-hooke").status == 2);
}

BOOST_AUTO_TEST_SUITE_END()
