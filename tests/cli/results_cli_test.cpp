#include "tests/cli/program.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>

BOOST_AUTO_TEST_SUITE(results_cli_test)

namespace {

const std::string small = "--cells 4,4,4 ";

}  // namespace

// Result files between commands: gates, tables, sweeps, merges.

BOOST_AUTO_TEST_CASE(gates_end_with_the_status_that_ci_reads) {
  const auto write = [](const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
  };
  const std::string head =
      "# kept\n[[gate]]\nname = 'force'\nreason = 'an example'\n"
      "where = { scene = 'compression', method = 'mss-cf' }\nmeasure = 'plate_force'\n";
  BOOST_TEST(
      run_springcheck("run compression --method mss-cf --out gated.h5 " + small).status ==
      0);
  write("pass.toml", head + "at_least = 1\nat_most = 2 # N\n");
  const Run pass = run_springcheck("gate pass.toml gated.h5 --junit junit.xml");
  BOOST_TEST(pass.status == 0, pass.err);
  BOOST_TEST(pass.out.find("1 pass, 0 fall short") != std::string::npos, pass.out);
  BOOST_TEST(text_of(folder / "junit.xml").find("failures=\"0\"") != std::string::npos);

  // No force is both of one sign and below every bound.
  write("impossible.toml", head + "at_least = 0\nat_most = 1e-300\n");
  const Run falls_short =
      run_springcheck("gate impossible.toml gated.h5 --junit junit.xml");
  BOOST_TEST(falls_short.status == 1, falls_short.out);
  BOOST_TEST(falls_short.out.find("impossible.toml:2:1") != std::string::npos);
  BOOST_TEST(text_of(folder / "junit.xml").find("<failure") != std::string::npos);

  // A missing case outweighs one that falls short; both are reported.
  write("missing.toml",
        head +
            "at_most = 1e-300\n[[gate]]\nname = 'other'\nreason = 'an example'\n"
            "where = { scene = 'shearing' }\nexpect = 'ok'\n");
  const Run missing = run_springcheck("gate missing.toml gated.h5 --json");
  BOOST_TEST(missing.status == 2);
  const Json json = Json::parse(missing.out);
  BOOST_TEST(json["verdicts"][0]["verdict"] == "falls short");
  BOOST_TEST(json["verdicts"][1]["verdict"] == "no case");

  write("bad.toml", head + "at_mots = 2\n");
  expect_bad_input("gate bad.toml gated.h5",
                   "bad.toml:7:1: unknown key 'at_mots', did you mean 'at_most'?");
  expect_bad_input("gate pass.toml none.h5", "none.h5: expected a result file");
  expect_bad_input("gate speed gated.h5",
                   "unknown gate 'speed', expected one of accuracy, thesis");
  expect_bad_input("gate nu kept.h5",
                   "expected a gate file, got 'nu', a sweep, which springcheck "
                   "sweep takes");
  expect_bad_input("gate accuracy gated.h5 --bless", "part of the program");
  expect_bad_input("gate pass.toml gated.h5 --junit none/junit.xml", "none/junit.xml");
  BOOST_TEST(run_springcheck("gate thesis gated.h5").status == 2);  // none of its cases

  const std::string stored = head + "equals = 3.0  # N\nrelative = 1e-9\n";
  write("stored.toml", stored);
  BOOST_TEST(run_springcheck("gate stored.toml gated.h5").status == 1);
  BOOST_TEST(text_of(folder / "stored.toml") == stored);
  const Run blessed = run_springcheck("gate stored.toml gated.h5 --bless");
  BOOST_TEST(blessed.status == 0, blessed.err);
  BOOST_TEST(blessed.out.find("blessed force: 3.0 -> 1.29") != std::string::npos);
  BOOST_TEST(text_of(folder / "stored.toml").find("  # N\n") != std::string::npos);
  BOOST_TEST(run_springcheck("gate stored.toml gated.h5").status == 0);
}

// Cases that differ in a setting alone have a column for it; all formats tell the same.
BOOST_AUTO_TEST_CASE(cases_are_written_for_other_programs) {
  std::ofstream(folder / "told.toml")
      << "[[cases]]\nscene = 'compression'\ncells = [2, 2, 2]\nmethod = 'mss-cf'\n"
         "stiffness-form = ['mu', 'E']\ndensity = [1000, 1060]\n";
  BOOST_TEST(run_springcheck("sweep told.toml --out told.h5").status == 0);
  const Run csv = run_springcheck("export told.h5 --out told.csv");
  BOOST_TEST(csv.status == 0, csv.err);
  BOOST_TEST(csv.out.starts_with("told.csv: 4 cases, "), csv.out);
  const std::string text = text_of(folder / "told.csv");
  const std::string head = text.substr(0, text.find('\n'));
  for (const char* column :
       {"density [kg/m^3]", "stiffness-form", "plate_force [N]", "status"})
    BOOST_TEST(head.find(column) != std::string::npos, head);
  BOOST_TEST(lines(text) == 5U);

  BOOST_TEST(
      run_springcheck("export told.h5 --out told.json --columns density,plate_force")
          .status == 0);
  const Json json = Json::parse(text_of(folder / "told.json"));
  BOOST_TEST(json["columns"][0]["unit"] == "kg/m^3");
  BOOST_TEST(json["cases"].size() == 4U);
  BOOST_TEST(json["cases"][0].size() == 2U);
  BOOST_TEST(json["cases"][0]["plate_force"].get<double>() > 0);

  BOOST_TEST(run_springcheck("export told.h5 --out told.parquet").status == 0);
  BOOST_TEST(text_of(folder / "told.parquet").starts_with("PAR1"));

  expect_bad_input("export told.h5 --out told.xlsx", ".csv, .parquet or .json");
  expect_bad_input("export told.h5 --out none/told.csv", "none/told.csv");
  expect_bad_input("export told.h5 --out a.csv --columns plate_farce",
                   "did you mean 'plate_force'?");
  expect_bad_input("export told.csv --out a.csv", "told.csv");
  BOOST_TEST(!fs::exists(folder / "a.csv"));
}

BOOST_AUTO_TEST_CASE(a_result_file_feeds_a_table_without_computing) {
  BOOST_TEST(run_springcheck("run compression --out one.h5 " + small).status == 0);
  BOOST_TEST(fs::exists(folder / "one.h5"));
  BOOST_TEST(fs::exists(folder / "one.xdmf"));
  // A result file that cannot be replaced stays as it was.
  const std::string before = text_of(folder / "one.h5");
  expect_bad_input("run compression --nu 2 --out one.h5", "--nu");
  BOOST_TEST(text_of(folder / "one.h5") == before);
}

// An end in the middle, by what no program can catch, as soon as the file has a case.
BOOST_AUTO_TEST_CASE(what_was_computed_is_kept_when_a_run_or_a_table_is_ended) {
  const auto kept_cases = [](const std::string& arguments, const std::string& name) {
    run_springcheck(arguments + " --out " + name,
                    "sh -c '\"$@\" & until grep -qs mss- " + name +
                        " || ! kill -0 $!; do sleep .01; done; kill -9 $!' sh ");
    const Run merged = run_springcheck("merge merged-" + name + " " + name);
    BOOST_TEST_REQUIRE(merged.out.starts_with(name + ": "), merged.err);
    return std::stoi(merged.out.substr(name.size() + 2));
  };
  const int of_run =
      kept_cases("run shearing --method mss-cf --cells 4,4,4 --split", "ended-run.h5");
  BOOST_TEST(of_run >= 1);
  BOOST_TEST(of_run < 13);  // itself, and six grids of two laws
  const int of_table = kept_cases("table 5.1", "ended-table.h5");
  BOOST_TEST(of_table >= 1);
  BOOST_TEST(of_table < 88);
}

BOOST_AUTO_TEST_CASE(a_sweep_resumes_what_a_file_holds) {
  std::ofstream(folder / "small.toml")
      << "scene = ['compression', 'shearing']\nmethod = 'fem-hooke'\nelement = ['q1', "
         "'q1-sri']\n"
         "cells = [3, 3, 3]\nnu = {from = 0.1, to = 0.4, count = 4}\n";
  const Run dry = run_springcheck("sweep small.toml --out sweep.h5 --dry-run");
  BOOST_TEST(dry.status == 0);
  const std::string usual =
      "deviations are from fem-stvk:q1-sri, where a case names no other reference\n";
  BOOST_TEST(
      dry.out.starts_with("small: 16 cases, 16 of them to compute\n" + usual + "about "),
      dry.out);
  BOOST_TEST(!fs::exists(folder / "sweep.h5"));
  BOOST_TEST(run_springcheck("sweep small.toml --out sweep.h5 --shard 1/2").out ==
             "small: 8 cases, 8 of them to compute\n" + usual + "computed: 8 ok\n");
  BOOST_TEST(run_springcheck("sweep small.toml --out sweep.h5").out ==
             "small: 16 cases, 8 of them to compute\n" + usual + "computed: 8 ok\n");
  BOOST_TEST(run_springcheck("sweep small.toml --out sweep.h5").out ==
             "small: 16 cases, 0 of them to compute\n" + usual);
  BOOST_TEST(run_springcheck("merge all.h5 sweep.h5 sweep.h5").out ==
             "sweep.h5: 16 cases added, 0 already there\n"
             "sweep.h5: 0 cases added, 16 already there\n");
  BOOST_TEST(!fs::exists(folder / "sweep.h5.lock"));
}

BOOST_AUTO_TEST_CASE(bad_sweeps_and_files_are_refused) {
  std::ofstream(folder / "one.toml") << "scene = 'compression'\n";
  std::ofstream(folder / "huge.toml")
      << "scene = 'compression'\nmethod = 'mss-cf'\n"
         "nu = {from = 0, to = 0.4, count = 2000}\n"
         "deformation = {from = 0.01, to = 0.4, count = 1000}\n";
  std::ofstream(folder / "text.h5") << "no HDF5";
  expect_bad_input("sweep one.toml --out text.h5", "text.h5");
  expect_bad_input("sweep huge.toml --out a.h5",
                   "expected at most 1000000 without --yes, got 2000000");
  expect_bad_input("sweep two.toml --out a.h5", "a readable sweep file");
  expect_bad_input("sweep nn --out a.h5",
                   "one of accuracy, beam-diagonal-ratio, deformation");
  expect_bad_input("sweep one.toml", "--out");
  expect_bad_input(
      "sweep kidney --out a.h5",
      "expected a sweep file, got 'kidney', a scene, which springcheck run takes");
  expect_bad_input(
      "run one.toml",
      ": expected a scene file, got a sweep file, which springcheck sweep takes");
  expect_bad_input("sweep one.toml --out a.h5 --shard 3/2", "I/N with 1 <= I <= N");
  expect_bad_input("sweep one.toml --out nowhere/a.h5", "nowhere/a.h5");
  expect_bad_input("merge a.h5 text.h5", "text.h5");
  expect_bad_input("sweep one.toml --out a.xdmf", "beside it");
  expect_bad_input("merge a.h5 nowhere.h5", "no such file");
  BOOST_TEST(!fs::exists(folder / "a.h5"));
}

// The beginning of a file has the signature of HDF5.
BOOST_AUTO_TEST_CASE(a_file_that_was_cut_off_is_called_so) {
  BOOST_TEST(run_springcheck("run compression --method mss-cf --cells 2,2,2 --out cut.h5")
                 .status == 0);
  fs::resize_file(folder / "cut.h5", 5000);
  expect_bad_input("export cut.h5 --out cut.csv", "one that was cut off");
}

// No input is written over, and permissions stay.
BOOST_AUTO_TEST_CASE(gates_do_not_write_over_their_inputs) {
  BOOST_TEST(run_springcheck("run compression --method mss-cf --cells 2,2,2 --out in.h5")
                 .status == 0);
  std::ofstream(folder / "in.toml")
      << "[[gate]]\nname = 'a'\nwhere = { method = 'mss-cf' }\n"
         "measure = 'plate_force'\nequals = 1\nabsolute = 1e-9\nreason = 'none'\n";
  expect_bad_input("gate in.toml in.h5 --junit in.h5", "another file than in.h5");
  expect_bad_input("gate in.toml in.h5 --junit in.toml", "another file than in.toml");
  fs::permissions(folder / "in.toml", fs::perms(0600));
  BOOST_TEST(run_springcheck("gate in.toml in.h5 --bless").status == 0);
  BOOST_TEST((fs::status(folder / "in.toml").permissions() == fs::perms(0600)));
}

namespace {

/// Changes the file as if another program, with other formulas, had written it.
void make_foreign(const std::string& file) {
  std::ofstream(folder / "other.py") << R"(
import hashlib, sys
import h5py
with h5py.File(sys.argv[1], "r+") as file:
    file["provenance/revision"][...] = b"0123456789ab"
    for i, identity in enumerate(file["cases/identity"][()]):
        before = file["cases/key"][i].decode()
        key = hashlib.sha256(identity + b" 0123456789ab").hexdigest()
        file["cases/key"][i] = key
        if before in file["fields"]:
            file["fields"].move(before, key)
)";
  const std::string change =
      "cd " + folder.string() + " && /usr/bin/python3 other.py " + file;
  BOOST_TEST_REQUIRE(std::system(change.c_str()) == 0);
}

}  // namespace

// The file holds the same cases by a program with other formulas: nothing takes its
// figures unasked, and what is made of them says so.
BOOST_AUTO_TEST_CASE(figures_of_other_revisions_are_told) {
  std::ofstream(folder / "other.toml")
      << "scene = 'compression'\nmethod = ['mss-cf', 'fem-stvk']\ncells = [2, 2, 2]\n";
  std::ofstream(folder / "other-gate.toml")
      << "[[gate]]\nname = 'force'\nreason = 'an example'\n"
         "where = { method = 'mss-cf' }\nmeasure = 'plate_force'\nat_least = 0\n";
  const std::string sweep = "sweep ./other.toml --out other.h5 ",
                    gate = "gate other-gate.toml other.h5 ",
                    report = "report other.h5 --out other ",
                    accept = "--accept-other-revisions ";
  BOOST_TEST(run_springcheck(sweep).status == 0);
  make_foreign("other.h5");

  const Run all = run_springcheck(sweep + "--dry-run");
  BOOST_TEST(all.out.find("2 cases, 2 of them to compute") != std::string::npos, all.out);
  const Run none = run_springcheck(sweep + accept);
  BOOST_TEST(none.out.find("2 cases, 0 of them to compute") != std::string::npos,
             none.out);
  BOOST_TEST(none.err.find("2 of 0123456789ab)") != std::string::npos, none.err);

  const Run unasked = run_springcheck(gate);
  BOOST_TEST(unasked.status == 2);
  BOOST_TEST(unasked.out.find("2 of 0123456789ab)") != std::string::npos, unasked.out);
  const Run asked = run_springcheck(gate + accept);
  BOOST_TEST(asked.status == 0, asked.out);
  BOOST_TEST(asked.out.find("taken where there are none of its own") !=
             std::string::npos);
  BOOST_TEST(run_springcheck(gate + accept + "--junit other.xml").status == 0);
  BOOST_TEST(text_of(folder / "other.xml").find("2 of 0123456789ab)") !=
             std::string::npos);
  expect_bad_input("gate ./other-gate.toml other.h5 --bless " + accept,
                   "figures of this program's revision alone");
  const Json json = json_of(gate + accept + "--json");
  BOOST_TEST(json["other_revisions"]["0123456789ab"] == 2);
  BOOST_TEST(json["accepts_other_revisions"] == true);

  expect_bad_input(report, "not taken without --accept-other-revisions");
  BOOST_TEST(run_springcheck(report + accept).status == 0);
  const std::string note =
      "Made of cases of other revisions of the numerics (2 of 0123456789ab)";
  BOOST_TEST(text_of(folder / "other/tables/cases.md").find(note) != std::string::npos);
  BOOST_TEST(text_of(folder / "other/index.html").find("id=\"revisions\">" + note) !=
             std::string::npos);
  expect_bad_input("chart compression --out other.h5 --sizes 2",
                   "a file of cases of revision");

  // The program's own cases stand beside the other's, which the page then leaves out.
  BOOST_TEST(run_springcheck(sweep).status == 0);
  BOOST_TEST(run_springcheck(report).status == 0);
  const std::string page = text_of(folder / "other/index.html");
  BOOST_TEST(page.find("Made of cases of other revisions") == std::string::npos);
  BOOST_TEST(page.find("2 of 0123456789ab)") != std::string::npos);
  BOOST_TEST(run_springcheck(gate).status == 0);
}

// What was taken from another revision is not stored as this program's own either.
BOOST_AUTO_TEST_CASE(what_is_taken_of_other_revisions_stays_theirs,
                     *boost::unit_test::label("slow")) {
  const std::string accept = " --accept-other-revisions ",
                    table = "table 5.4 --format md ",
                    map =
                        "stability compression --method mss-nfd --cells 3,3,3 "
                        "--over deformation=2%:30%:3 --out other-map.h5";
  BOOST_TEST(run_springcheck(table + "--out other-table.h5").status == 0);
  make_foreign("other-table.h5");
  const Run taken =
      run_springcheck(table + "--from other-table.h5 --out taken.h5" + accept);
  BOOST_TEST(taken.status == 0, taken.err);
  BOOST_TEST(taken.out.find(" of 0123456789ab)") != std::string::npos, taken.out);
  expect_bad_input("report taken.h5 --out taken", "of 0123456789ab)");
  BOOST_TEST(run_springcheck(table + "--from taken.h5 " + accept).out == taken.out);

  BOOST_TEST(run_springcheck(map).status == 0);
  make_foreign("other-map.h5");
  const Run mapped = run_springcheck(map + accept);
  BOOST_TEST(mapped.out.find("\n0 simulations computed") != std::string::npos,
             mapped.out);
  BOOST_TEST(mapped.out.find(" of 0123456789ab)") != std::string::npos, mapped.out);
  const Run tables = run_springcheck(map + accept + "--format md");
  BOOST_TEST(tables.out.find(" of 0123456789ab)") != std::string::npos, tables.out);
}

// Two would mix their files: the second waits for nobody, and changes nothing.
BOOST_AUTO_TEST_CASE(a_folder_takes_one_report_at_a_time) {
  BOOST_TEST(run_springcheck("run compression --method mss-cf --cells 2,2,2 --out one.h5")
                 .status == 0);
  BOOST_TEST(run_springcheck("report one.h5 --out one").status == 0);
  const std::string page = text_of(folder / "one/index.html");
  const std::string note = text_of(folder / "one/data/revisions.json");
  fs::remove(folder / "one/data/revisions.json");
  const Run second = run_springcheck("report one.h5 --out one", "flock one/data ");
  BOOST_TEST(second.status == 2);
  BOOST_TEST(second.err.find("no other report is made in") != std::string::npos,
             second.err);
  BOOST_TEST(!fs::exists(folder / "one/data/revisions.json"));
  BOOST_TEST(text_of(folder / "one/index.html") == page);
  BOOST_TEST(run_springcheck("report one.h5 --out one").status == 0);
  BOOST_TEST(text_of(folder / "one/data/revisions.json") == note);
}

BOOST_AUTO_TEST_SUITE_END()
