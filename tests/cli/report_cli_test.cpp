#include "tests/cli/program.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <set>

BOOST_AUTO_TEST_SUITE(report_cli_test)

namespace {

/// The names in a folder.
std::set<std::string> names_in(const fs::path& place) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder / place))
    names.insert(entry.path().filename().string());
  return names;
}

Json json_in(const fs::path& file) {
  return Json::parse(text_of(folder / file));
}

const auto round_off = boost::test_tools::tolerance(1e-12);

}  // namespace

// Nothing is computed: two of the twelve rows of table 5.3, with the value of the
// reference where that was run as well.
BOOST_AUTO_TEST_CASE(a_report_has_the_rows_whose_cases_are_in_the_file) {
  BOOST_TEST(
      run_springcheck("run shearing --method mss-cf,fem-stvk --nu 0.25 --deformation "
                      "5% --out some.h5")
          .status == 0);
  const Run run = run_springcheck("report some.h5 --out some");
  BOOST_TEST(run.status == 0, run.err);
  BOOST_TEST(run.out.find("Start with some/index.html\n") != std::string::npos, run.out);
  BOOST_TEST(fs::exists(folder / "some/index.html"));
  std::set<std::string> files;
  for (const char* table : {"5.3", "5.5", "cases"})
    for (const char* extension : {".csv", ".json", ".md", ".tex"})
      files.insert(std::string(table) + extension);
  BOOST_TEST(names_in("some/tables") == files, boost::test_tools::per_element());

  const Json table = json_in("some/tables/5.3.json");
  BOOST_TEST_REQUIRE(table["rows"].size() == 2U);
  BOOST_TEST(table["rows"][0]["reference"] == "fem-stvk:q1-sri");
  BOOST_TEST(table["rows"][0]["reference_value"] == table["rows"][1]["ours"]);
  const std::string note =
      "2 of 26 rows: the result file lacks the cases of the others; `springcheck table "
      "5.3 --from some.h5` computes them.";
  BOOST_TEST(table["notes"].back() == note);
  BOOST_TEST(text_of(folder / "some/tables/5.3.md").find(note) != std::string::npos);
  BOOST_TEST(lines(text_of(folder / "some/tables/5.3.csv")) == 3U);
  BOOST_TEST(text_of(folder / "some/tables/5.3.tex").find("\\begin{tabular}") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_reference_that_is_lacking_has_no_value) {
  BOOST_TEST(run_springcheck("run torsion --method mss-cf --nu 0.25 --deformation 45deg "
                             "--out alone.h5")
                 .status == 0);
  BOOST_TEST(run_springcheck("report alone.h5 --out alone").status == 0);
  const Json table = json_in("alone/tables/5.4.json");
  BOOST_TEST_REQUIRE(table["rows"].size() == 1U);
  BOOST_TEST(table["rows"][0]["ours"].is_number());
  BOOST_TEST(table["rows"][0]["reference_value"].is_null());
}

// What an earlier report left would be shown as this file's.
BOOST_AUTO_TEST_CASE(cases_of_one_s_own_fill_the_table_of_all_cases_alone) {
  BOOST_TEST(
      run_springcheck("run compression --cells 2,2,2 --nu 0.3 --out own.h5").status == 0);
  fs::create_directories(folder / "own/tables");
  std::ofstream(folder / "own/tables/5.1.md") << "of another file";
  const Run run = run_springcheck("report own.h5 --out own");
  BOOST_TEST(run.status == 0, run.err);
  const std::set<std::string> files{"cases.csv", "cases.json", "cases.md", "cases.tex"};
  BOOST_TEST(names_in("own/tables") == files, boost::test_tools::per_element());
  const Json cases = json_in("own/tables/cases.json");
  BOOST_TEST_REQUIRE(cases["rows"].size() == 2U);
  BOOST_TEST(cases["rows"][0]["method"] == "fem-stvk:q1-sri");
  BOOST_TEST(cases["rows"][1]["method"] == "mss-cf");
  BOOST_TEST(cases["rows"][1]["mesh"] == "2x2x2 hexahedron");
  BOOST_TEST(cases["rows"][1]["nu"] == .3);
  BOOST_TEST(json_in("own/data/theory.json")["beams"].empty());
}

BOOST_AUTO_TEST_CASE(rows_that_would_read_alike_tell_the_settings_that_differ) {
  for (const char* motion :
       {"", "--solver verlet --duration 0.01", "--solver verlet --duration 0.02"})
    BOOST_TEST(
        run_springcheck(std::string("run compression --cells 2,2,2 --method mss-cf --out "
                                    "alike.h5 ") +
                        motion)
            .status == 0);
  BOOST_TEST(run_springcheck("report alike.h5 --out alike").status == 0);
  const Json rows = json_in("alike/tables/cases.json")["rows"];
  std::set<std::string> words;
  for (const Json& row : rows)
    words.insert(row["further"].is_null() ? "" : row["further"].get<std::string>());
  BOOST_TEST(rows.size() == 3U);
  BOOST_TEST(words.size() == 3U);
  BOOST_TEST((words == std::set<std::string>{"", "duration 0.01", "duration 0.02"}));
  std::set<std::string> methods;
  for (const Json& row : rows) methods.insert(row["method"].get<std::string>());
  BOOST_TEST((methods == std::set<std::string>{"mss-cf", "mss-cf, verlet"}));
}

// kappa/E = (4 nu - 1)/(2 (1 + nu)(1 - 2 nu)); on a beam w L^4/(8 E I), and
// w L^2/(2 * 5/6 G A) more with shear. Round-off. The elastica keeps its length: chords
// of a 40th of it are shorter by less than 1e-4.
BOOST_AUTO_TEST_CASE(theory_has_the_closed_forms) {
  BOOST_TEST(
      run_springcheck("run bending --method mss-cf,fem-stvk --cells 2,2,8 --young 4e6 "
                      "--out beam.h5")
          .status == 0);
  BOOST_TEST(run_springcheck(
                 "run bending --method mss-cf --cells 2,2,12 --size 0.3,0.4,2.4 --out "
                 "beam.h5")
                 .status == 0);
  BOOST_TEST(run_springcheck("report beam.h5 --out beam").status == 0);
  const Json theory = json_in("beam/data/theory.json");
  const Json& modulus = theory["volume_modulus"];
  BOOST_TEST(theory["methods"]["mss-cf"].get<std::string>().size() > 10U);
  BOOST_TEST_REQUIRE(modulus["cases"].size() == 1U);
  const double used = modulus["cases"][0]["nu"];
  BOOST_TEST(modulus["cases"][0]["kappa_over_young"].get<double>() ==
                 (4 * used - 1) / (2 * (1 + used) * (1 - 2 * used)),
             round_off);
  BOOST_TEST(modulus["source"] == "Golec 2018, Eq. 5.36");
  BOOST_TEST(modulus["nu"].size() == modulus["kappa_over_young"].size());
  for (std::size_t i = 0; i < modulus["nu"].size(); ++i) {
    const double nu = modulus["nu"][i];
    BOOST_TEST(modulus["kappa_over_young"][i].get<double>() ==
                   (4 * nu - 1) / (2 * (1 + nu) * (1 - 2 * nu)),
               round_off);
  }

  BOOST_TEST_REQUIRE(theory["beams"].size() == 2U);
  const Json &square = theory["beams"][0], &narrow = theory["beams"][1];
  BOOST_TEST(square["cases"].size() == 2U);
  BOOST_TEST(narrow["cases"].size() == 1U);
  BOOST_TEST(square["young"] == 4e6);
  BOOST_TEST(square["gravity"] == 10.);
  BOOST_TEST(narrow["height"] == 0.3);  // along gravity
  BOOST_TEST(narrow["width"] == 0.4);
  for (const Json& beam : theory["beams"]) {
    const double E = beam["young"], L = beam["length"], h = beam["height"],
                 b = beam["width"], nu = beam["nu"];
    const double w = beam["density"].get<double>() * 10 * b * h;
    const double straight = w * std::pow(L, 4) / (8 * E * b * std::pow(h, 3) / 12);
    const double shear = w * L * L / (2 * 5. / 6 * E / (2 * (1 + nu)) * b * h);
    const Json &s = beam["arc_length"], &bent = beam["euler_bernoulli"];
    BOOST_TEST(s.size() == 41U);
    BOOST_TEST(s[40].get<double>() == L, round_off);
    BOOST_TEST(bent["drop"][40].get<double>() == straight, round_off);
    BOOST_TEST(bent["axial"][20].get<double>() == s[20].get<double>(), round_off);
    BOOST_TEST(beam["timoshenko"]["drop"][40].get<double>() == straight + shear,
               round_off);
    const Json& elastica = beam["elastica"];
    double length = 0;
    for (std::size_t i = 1; i < 41; ++i)
      length += std::hypot(
          elastica["drop"][i].get<double>() - elastica["drop"][i - 1].get<double>(),
          elastica["axial"][i].get<double>() - elastica["axial"][i - 1].get<double>());
    BOOST_TEST(length == L, boost::test_tools::tolerance(1e-4));
    BOOST_TEST(elastica["drop"][40].get<double>() < straight);
  }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_reported_is_refused_before_anything_is_written) {
  BOOST_TEST(run_springcheck("run compression --cells 2,2,2 --out in.h5").status == 0);
  std::ofstream(folder / "text.h5") << "no HDF5";
  expect_bad_input("report text.h5 --out page", "text.h5");
  expect_bad_input("report none.h5 --out page", "none.h5: expected a result file");
  BOOST_TEST(!fs::exists(folder / "page"));
  expect_bad_input("report in.h5 --out /proc/nowhere",
                   "/proc/nowhere: expected a folder that can be created");
  expect_bad_input("report in.h5 --out text.h5", "text.h5: expected a folder");
  expect_bad_input("report in.h5", "--out");
}

// PYTHONHOME without a Python ends it at once.
BOOST_AUTO_TEST_CASE(a_program_that_fails_fails_the_report_and_leaves_no_trace) {
  BOOST_TEST(run_springcheck("run compression --cells 2,2,2 --out in.h5").status == 0);
  fs::create_directory(folder / "tmp");
  const Run run =
      run_springcheck("report in.h5 --out failed", "TMPDIR=./tmp PYTHONHOME=/nowhere ");
  BOOST_TEST(run.status == 1);
  BOOST_TEST(run.out.find("Start with") == std::string::npos);
  BOOST_TEST(names_in("tmp").empty());
}

// Sources of the report's program are in a folder of its own, which none leaves behind:
// what a killed one left goes with the next report, but never what others still use.
BOOST_AUTO_TEST_CASE(a_report_leaves_no_folder) {
  BOOST_TEST(run_springcheck("run compression --cells 2,2,2 --out one.h5").status == 0);
  const std::string own = "TMPDIR=" + (folder / "tmp").string() + " ";
  const fs::path killed = "tmp/springcheck-report-killed",
                 used = "tmp/springcheck-report-used", other = "tmp/springcheck-other";
  for (const fs::path& left : {killed, used, other}) {
    fs::create_directories(folder / left / "springcheck_report");
    std::ofstream(folder / left / "in-use").flush();
  }
  const int lock = open((folder / used / "in-use").c_str(), O_RDWR);
  BOOST_TEST_REQUIRE(flock(lock, LOCK_EX | LOCK_NB) == 0);
  const std::set<std::string> kept{"springcheck-report-used", "springcheck-other"};
  BOOST_TEST(run_springcheck("report one.h5 --out page", own).status == 0);
  BOOST_TEST(names_in("tmp") == kept, boost::test_tools::per_element());
  run_springcheck("report one.h5 --out page", own + "timeout --foreground -s HUP 1 ");
  BOOST_TEST(names_in("tmp") == kept, boost::test_tools::per_element());
  close(lock);
}

BOOST_AUTO_TEST_SUITE_END()
