#include "tests/cli/program.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

BOOST_AUTO_TEST_SUITE(chart_cli_test)

namespace {

// Truths on 1, 2 and 4 cells across are rough, and quick.
const std::string quick = " --converged-across 1 --budget 1 ";
const std::string quickest = " --converged-across 1 --budget .1 ";

const Run& charted() {
  static const Run run = run_springcheck(
      "chart compression --sizes 2 --on-threads 1 --out chart.h5" + quick);
  return run;
}

std::string advise(const std::string& options, const std::string& speed = quick) {
  return "advise compression --out chart.h5" + speed + options;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

struct Advised {
  double percent_off, unsure, seconds;
};

/// Figures of the row that starts so.
std::optional<Advised> row(const std::string& first, const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(first)) continue;
    std::istringstream words(line);
    std::vector<std::string> all;
    for (std::string word; words >> word;) all.push_back(word);
    // Errors and bounds of force, volume and deviation, the time, the case.
    return Advised{.percent_off = std::stod(all.at(all.size() - 8)),
                   .unsure = std::stod(all.at(all.size() - 7)),
                   .seconds = std::stod(all.at(all.size() - 2))};
  }
  return std::nullopt;
}

double plate_force(const std::string& run) {
  const Run ran = run_springcheck("run " + run + " --json");
  BOOST_TEST(ran.status == 0, ran.err);
  const Json result = Json::parse(ran.out)["results"][0];
  BOOST_TEST(result["status"] == "ok");
  return result["plate_force"];
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_chart_prints_truths_fronts_and_claims) {
  const Run& run = charted();
  BOOST_TEST(run.status == 0, run.err);
  for (const char* part :
       {"fem-cauchy-born  plate_force", "Fronts, law fem-stvk",
        "equilibrium, force: mss-cf", "motion, deviation: mss-affine, double",
        "0 left out: over budget or memory, or not applicable."})
    BOOST_TEST(holds(run.out, part), run.out);
}

BOOST_AUTO_TEST_CASE(a_chart_comes_back_from_its_file, *boost::unit_test::label("slow")) {
  charted();
  const std::string command =
      "chart compression --sizes 2 --on-threads 1 --out chart.h5 --format json" + quick;
  const Json first = json_of(command), again = json_of(command);
  BOOST_TEST(first.size() == 5U);
  BOOST_TEST((first == again));  // times too: nothing was measured again
  const Json retimed = json_of(command + " --retime");
  BOOST_TEST((retimed != first));
  for (std::size_t i = 0; i < first[1]["rows"].size(); ++i)
    BOOST_TEST((retimed[1]["rows"][i]["force"] == first[1]["rows"][i]["force"]));
}

BOOST_AUTO_TEST_CASE(advice_meets_the_tolerance_at_least_cost) {
  // Within 1 % of the limit of finer grids than the advice knew.
  const double truth =
      plate_force("compression --method fem-stvk --element q2 --cells 6,6,6");
  for (const double percent : {5, 10, 25}) {
    const Run run = run_springcheck(
        advise("--measure force --tolerance " + std::to_string(percent / 100)));
    BOOST_TEST(run.status == 0, run.out + run.err);
    const auto chosen = row("chosen", run.out), cheaper = row("cheaper", run.out),
               dearer = row("dearer", run.out);
    BOOST_TEST(holds(run.err, "what holds at 1.2 times the load"), run.err);
    BOOST_TEST_REQUIRE(chosen.has_value(), run.out);
    BOOST_TEST(chosen->percent_off + chosen->unsure <= percent, run.out);
    if (cheaper) BOOST_TEST(cheaper->percent_off + cheaper->unsure > percent, run.out);
    if (cheaper) BOOST_TEST(cheaper->seconds <= chosen->seconds, run.out);
    if (dearer) BOOST_TEST(dearer->seconds >= chosen->seconds, run.out);
    const double force = plate_force("./compression-advised.toml");
    BOOST_TEST(std::abs(force / truth - 1) <= percent / 100, run.out);
  }
}

// Steps, precision and constants of its own would not be a chart's.
BOOST_AUTO_TEST_CASE(a_scenes_own_way_to_be_simulated_is_not_a_charts,
                     *boost::unit_test::label("slow")) {
  std::ofstream(folder / "own-way.toml")
      << "test = \"compression\"\nyoung = 10e3\nnu = 0.25\ndensity = 1000\n"
         "size = [0.05, 0.05, 0.05]\ncells = [3, 3, 3]\ndeformation = 0.05\n"
         "method = \"mss-cf\"\nsolver = \"verlet\"\nprecision = \"float\"\n"
         "dt = 1e-6\ndistortion = 0.2\nnoise = 0.01\n";
  const std::string options = " --sizes 2 --on-threads 1 --format json" + quick;
  const Json plain = json_of("chart compression --out plain.h5" + options),
             own = json_of("chart ./own-way.toml --out own-way.h5" + options);
  BOOST_TEST(own[1]["rows"].size() == plain[1]["rows"].size());
  for (std::size_t i = 0; i < plain[1]["rows"].size(); ++i)
    for (const char* figure : {"force", "steps", "factorisations"})
      BOOST_TEST((own[1]["rows"][i][figure] == plain[1]["rows"][i][figure]));
}

BOOST_AUTO_TEST_CASE(advice_for_real_time_has_a_step_that_fits_the_frame) {
  const Run run = run_springcheck(advise(
      "--tolerance 25% --measure deviation --real-time .02 --scene-file motion.toml"));
  BOOST_TEST(run.status == 0, run.out + run.err);
  BOOST_TEST(holds(run.out, "frame takes [s]"), run.out);
  const std::string scene = text_of(folder / "motion.toml");
  BOOST_TEST(holds(scene, "solver = \"semi-implicit\""), scene);
  BOOST_TEST(holds(scene, "dt = "), scene);
  BOOST_TEST(run_springcheck("run motion.toml").status == 0);
}

// Springs of one Poisson's ratio cross the truth of another in force alone: mss-fd at
// nu = .37 by -9, -5, 0 and 10 % of it at 1, 4, 8 and 15 % of compression.
BOOST_AUTO_TEST_CASE(a_model_of_another_poisson_ratio_is_no_candidate) {
  const Run run =
      run_springcheck(advise("--nu .37 --deformation 8.3% --tolerance 5% --measure force",
                             " --converged-across 2 --budget 1 "));
  BOOST_TEST(run.status == 0, run.out + run.err);
  BOOST_TEST(row("chosen", run.out).has_value(), run.out);
  for (const char* other : {"mss-fd", "mss-uniform"})
    BOOST_TEST(!holds(run.out, other), run.out);
}

// By Hooke's law the force of a sheared cube is .1, 2, 2.7 and 3.1 % off on 2, 3, 4 and 6
// cells across.
BOOST_AUTO_TEST_CASE(a_crossing_is_told_and_not_chosen,
                     *boost::unit_test::label("slow")) {
  const Run run = run_springcheck(
      "advise shearing --nu .31 --deformation 13% --tolerance 2.3% --converged-across 2 "
      "--budget 1 "
      "--measure force");
  BOOST_TEST(run.status == 0, run.out + run.err);
  BOOST_TEST(holds(run.out, "a crossing, not chosen"), run.out);
  BOOST_TEST(holds(run.out, "- fem-hooke:q2 on 2 across: its law is 3.7"), run.out);
  const std::string chosen = run.out.substr(run.out.find("\nchosen"));
  BOOST_TEST(!holds(chosen.substr(0, chosen.find('\n', 1)), "fem-hooke"), run.out);
}

/// Sizes that the search does not try are points as good as others.
void take_in_a_chart_of(const std::string& sizes) {
  const std::string scene = "compression --nu .3 --out sizes-" + sizes + ".h5" + quickest;
  const Run chart =
      run_springcheck("chart " + scene + "--sizes " + sizes + " --on-threads 1");
  BOOST_TEST(chart.status == 0, chart.out + chart.err);
  const Run run = run_springcheck("advise " + scene + "--tolerance 30% --measure force");
  BOOST_TEST(run.status == 0, run.out + run.err);
}

BOOST_AUTO_TEST_CASE(a_chart_of_fewer_cells_than_are_tried_is_taken_in,
                     *boost::unit_test::label("slow")) {
  take_in_a_chart_of("1,3");
}

BOOST_AUTO_TEST_CASE(a_chart_of_cells_between_those_tried_is_taken_in,
                     *boost::unit_test::label("slow")) {
  take_in_a_chart_of("1,7");
}

// An option that takes several values leaves the scene alone.
BOOST_AUTO_TEST_CASE(options_may_stand_before_the_scene) {
  const Run run = run_springcheck(
      "advise --measure force,force compression --out chart.h5 --tolerance 25%" + quick);
  BOOST_TEST(run.status == 0, run.out + run.err);
  BOOST_TEST(run.out.starts_with("compression: force within 25 %"), run.out);
}

BOOST_AUTO_TEST_CASE(near_a_half_the_usual_law_is_cautioned_against) {
  const std::string pressed = "compression --nu .46 --deformation 5%",
                    words = "fem-stvk lets volume change near nu = 1/2";
  const Run advice = run_springcheck("advise " + pressed + " --tolerance 25%" + quick),
            chart = run_springcheck("chart " + pressed +
                                    " --sizes 2 --on-threads 1 --out half.h5" + quickest),
            run = run_springcheck("run " + pressed + " --cells 2,2,2");
  for (const Run& one : {advice, chart, run}) BOOST_TEST(holds(one.out, words), one.out);
  BOOST_TEST(!holds(run_springcheck("run compression --cells 2,2,2 --nu .49 "
                                    "--deformation 1%")
                        .out,
                    "lets volume change"));
  const Run hencky = run_springcheck(
      "advise " + pressed + " --tolerance 25% --converged-law fem-hencky" + quick);
  BOOST_TEST(holds(hencky.out, "what fem-hencky converges to"), hencky.out);
  BOOST_TEST(!holds(hencky.out, "lets volume change"), hencky.out);
}

BOOST_AUTO_TEST_CASE(truths_are_kept_for_other_scenes, *boost::unit_test::label("slow")) {
  const std::string cache = (folder / "kept").string();
  const std::string command =
      "advise compression --nu .2 --tolerance 25% --measure force" + quick;
  const auto advised = [&] {
    const Run run = run_springcheck(command, "XDG_CACHE_HOME=" + cache + " ");
    BOOST_TEST(run.status == 0, run.out + run.err);
    return run;
  };
  advised();
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder / "kept" / "springcheck"))
    if (entry.path().extension() == ".h5") files.push_back(entry.path());
  BOOST_TEST_REQUIRE(files.size() == 1U);
  const auto written = fs::last_write_time(files[0]);
  advised();
  BOOST_TEST((fs::last_write_time(files[0]) == written));  // all truths were there
  // A damaged one is left alone, and told of.
  std::ofstream(files[0]) << "no result file";
  BOOST_TEST(holds(advised().err, files[0].string()));
  BOOST_TEST(text_of(files[0]) == "no result file");
}

BOOST_AUTO_TEST_CASE(what_cannot_be_met_ends_with_the_nearest) {
  for (const char* wish : {"--tolerance 1e-9", "--tolerance 25% --real-time 1e-12"}) {
    const Run run = run_springcheck(
        advise(std::string(wish) + " --measure force --scene-file none.toml", quickest));
    BOOST_TEST(run.status == 1, run.out + run.err);
    BOOST_TEST(holds(run.out, "nearest"), run.out);
    BOOST_TEST(holds(run.out, "meets it"), run.out);
    BOOST_TEST(!fs::exists(folder / "none.toml"));
  }
}

// Its own reference is on a grid that refines the cells it had.
BOOST_AUTO_TEST_CASE(an_advised_scene_runs_whatever_the_reference_was) {
  const std::string scene = text_of("comparisons/shipped/scenes/compression.toml");
  std::ofstream(folder / "finer-reference.toml")
      << scene << "reference = \"fem-stvk@20\"\n";
  const Run run = run_springcheck(
      "advise ./finer-reference.toml --tolerance 25% --scene-file advised.toml" + quick);
  BOOST_TEST(run.status == 0, run.out + run.err);
  BOOST_TEST(run_springcheck("run ./advised.toml").status == 0);
  BOOST_TEST(holds(text_of(folder / "advised.toml"), "reference = \"fem-stvk\""));
}

BOOST_AUTO_TEST_CASE(a_scene_of_the_users_own_is_not_lost) {
  const std::string own = "test = \"compression\"\n";
  std::ofstream(folder / "own.toml") << own;
  expect_bad_input(advise("--tolerance 8% --scene-file own.toml"),
                   "the scene of earlier advice, or none");
  BOOST_TEST(text_of(folder / "own.toml") == own);
}

BOOST_AUTO_TEST_CASE(without_a_truth_there_is_no_advice,
                     *boost::unit_test::label("slow")) {
  const Run run =
      run_springcheck("advise compression --tolerance 8% --deformation 95%" + quick);
  BOOST_TEST(run.status == 1, run.out + run.err);
  BOOST_TEST(holds(run.err, "no converged solution"), run.err);
  BOOST_TEST(holds(run.err, "--converged-law"), run.err);
}

BOOST_AUTO_TEST_CASE(bad_input_names_what_was_expected) {
  expect_bad_input("advise compression --tolerance 0", "a number above 0");
  expect_bad_input("advise compression --tolerance -8%", "a number above 0");
  // A percentage without its sign.
  expect_bad_input("advise compression --tolerance 8", "below 1, such as 0.08 or '8%'");
  expect_bad_input("advise compression --tolerance much", "as in '5%'");
  expect_bad_input("advise compression --tolerance 8% --measure energy",
                   "force, volume, deviation");
  expect_bad_input("advise compression --tolerance 8% --measure force,volum",
                   "did you mean 'volume'");
  expect_bad_input("advise compression --tolerance 8% --converged-law hencky",
                   "fem-hooke, fem-stvk, fem-hencky, fem-cauchy-born");
  expect_bad_input("chart compression --out x.h5 --converged-law fem-henky",
                   "did you mean 'fem-hencky'");
  expect_bad_input("advise compression --tolerance 8% --real-time 0",
                   "a positive finite number");
  expect_bad_input("advise compression --tolerance 8% --budget 0", "above 0");
  expect_bad_input("advise kidney --tolerance 8% --measure deviation", "force or volume");
  expect_bad_input(
      "advise compression --tolerance 8% --out same.toml --scene-file same.toml",
      "not read or written otherwise");
  expect_bad_input("advise nowhere --tolerance 8%", "nowhere");
  expect_bad_input("advise traction --tolerance 8%", "a plate or a weight");
  expect_bad_input("chart compression --out x.h5 --sizes 4,4", "different whole numbers");
  expect_bad_input("chart compression --out x.h5 --sizes 4,", "different whole numbers");
  expect_bad_input("chart compression --out x.h5 --sizes 0", "different whole numbers");
  expect_bad_input("chart compression --out x.h5 --on-threads 5000",
                   "whole numbers from 1");
  expect_bad_input("chart compression --out x.h5 --method mss-cf", "--method");
  expect_bad_input("chart compression --out x.h5 --least-models -1", "--least-models");
  expect_bad_input("chart compression", "--out");
  expect_bad_input("chart affine --out x.h5", "a plate or a weight");
  BOOST_TEST(!fs::exists(folder / "x.h5"));
}

BOOST_AUTO_TEST_SUITE_END()
