#include "tests/cli/program.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <set>
#include <sstream>

BOOST_AUTO_TEST_SUITE(cli_test)

namespace {

const std::string small = "--cells 4,4,4 ";

}  // namespace

BOOST_AUTO_TEST_CASE(run_prints_the_documented_json) {
  const Run run =
      run_springcheck("run compression --method mss-cf,fem-hooke --json " + small);
  BOOST_TEST(run.status == 0);
  BOOST_TEST(run.err.empty(), run.err);
  const Json json = Json::parse(run.out);
  BOOST_TEST(json["scene"] == "compression");
  BOOST_TEST(json["springcheck"].is_string());
  BOOST_TEST_REQUIRE(json["results"].size() == 2U);
  const Json& springs = json["results"][0];
  for (const char* key : {"method",
                          "element",
                          "solver",
                          "nu",
                          "young",
                          "density",
                          "deformation",
                          "mesh",
                          "status",
                          "flags",
                          "reason",
                          "volume_error",
                          "volume_change",
                          "cell_volume_ratio_min",
                          "cell_volume_ratio_max",
                          "force",
                          "torque",
                          "plate_force",
                          "plate_force_norm",
                          "plate_torque",
                          "mean_deviation",
                          "max_deviation",
                          "middle_layer_deviation",
                          "deviation_l2_relative",
                          "reference",
                          "tip_deflection",
                          "face_displacement",
                          "mean_stress",
                          "affine_deviation_relative",
                          "definite_up_to_deformation",
                          "traction",
                          "gradient",
                          "strain_energy",
                          "steps",
                          "linear_iterations",
                          "factorisations",
                          "dt",
                          "dt_limit",
                          "force_evaluations",
                          "wall_s",
                          "solve_wall_s"})
    BOOST_TEST(springs.contains(key), key);
  for (const char* key : {"cells", "nodes", "types", "sha256"})
    BOOST_TEST(springs["mesh"].contains(key), key);
  BOOST_TEST(springs["method"] == "mss-cf");
  BOOST_TEST(springs["element"].is_null());
  BOOST_TEST(springs["dt"].is_null());
  BOOST_TEST(springs["tip_deflection"].is_null());
  BOOST_TEST(springs["reference"] == "fem-stvk:q1-sri");
  BOOST_TEST(json["results"][1]["element"] == "q1-sri");
  BOOST_TEST(springs["mesh"]["types"]["hexahedron"] == 64);
}

BOOST_AUTO_TEST_CASE(run_prints_a_readable_table) {
  const Run run = run_springcheck("run shearing --method mss-cf " + small);
  BOOST_TEST(run.status == 0);
  BOOST_TEST(run.out.find("method") != std::string::npos);
  BOOST_TEST(run.out.find("Deviations are from fem-stvk:q1-sri") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(options_reach_the_simulation) {
  const Json result = json_of(
      "run torsion --method mss-cf --nu 0.3 --young 2e4 --density 900 "
      "--deformation 10deg --size 0.04,0.04,0.04 --json " +
      small)["results"][0];
  BOOST_TEST(result["nu"] == 0.3);
  BOOST_TEST(result["young"] == 2e4);
  BOOST_TEST(result["density"] == 900);
  BOOST_TEST(std::abs(result["deformation"].get<double>() - 10 * M_PI / 180) < 1e-15);
  BOOST_TEST(result["plate_force"].is_null());  // torsion has no direction for it
  BOOST_TEST(result["plate_torque"].get<double>() > 0);
}

BOOST_AUTO_TEST_CASE(loads_are_options_and_negative_numbers_are_values) {
  const Json pressed =
      json_of("run uniaxial --method mss-cf --deformation -5% --json")["results"][0];
  BOOST_TEST(pressed["deformation"] == -0.05);
  BOOST_TEST(pressed["plate_force"].get<double>() > 0);
  BOOST_TEST(pressed["force"][2].get<double>() < 0);
  const Json pulled = json_of(
      "run traction --method mss-cf --plates glued --traction -60,-30,100 "
      "--json")["results"][0];
  BOOST_TEST(pulled["status"] == "ok");
  BOOST_TEST(pulled["traction"] == Json({-60, -30, 100}));
  BOOST_TEST(pulled["deformation"].is_null());
  BOOST_TEST(pulled["face_displacement"][0].get<double>() < 0);
  const Json affine = json_of(
      "run affine --method mss-cf --gradient -.1,0,0,0,0,0.2,0,0,0 --json")["results"][0];
  BOOST_TEST(affine["gradient"][1][2] == 0.2);
  BOOST_TEST(affine["mean_stress"][0][0].get<double>() < 0);  // pressed along x
  BOOST_TEST(affine["mean_stress"].size() == 3U);
  BOOST_TEST(affine["affine_deviation_relative"].get<double>() < 1e-10);
  BOOST_TEST(affine["wrinkle_alternation"].is_null());
  BOOST_TEST(affine["plate_force"].is_null());
}

BOOST_AUTO_TEST_CASE(finite_element_keys_reach_the_simulation) {
  const auto force = [](const std::string& options) {
    const Json result =
        json_of("run uniaxial --method fem-cauchy-born --json " + options)["results"][0];
    BOOST_TEST(result["status"] == "ok", options);
    return result["plate_force"].get<double>();
  };
  BOOST_TEST(force("--lattice-direction 111") != force(""));
  BOOST_TEST(force("--lattice mss-affine") != force(""));
  BOOST_TEST(force("--element q2") == force(""), boost::test_tools::tolerance(1e-8));
  const Json iterated =
      json_of("run compression --method fem-hencky --linear-solver multigrid --json " +
              small)["results"][0];
  BOOST_TEST(iterated["linear_iterations"].get<int>() > 0);
  BOOST_TEST(json_of("run compression --method fem-hencky --json " +
                     small)["results"][0]["linear_iterations"]
                 .is_null());
}

// Mu = 2800 Pa and cells of 12.5 mm: k_c = 3 mu h/7 = 15, k_e = 11/3 k_c = 55 N/m; kappa
// = E (4 nu - 1)/(2 (1 + nu)(1 - 2 nu)). Both reach a residual of 1e-10.
BOOST_AUTO_TEST_CASE(springs_of_one_s_own_with_the_constants_of_mss_cf_are_mss_cf) {
  for (const char* material :
       {"--young 5600 --nu 0 --kappa -2800", "--young 7000 --nu .25",
        "--young 7840 --nu .4 --kappa 8400"}) {
    const Json results =
        json_of("run shearing --method mss-cf,mss-custom --stiffness 55,15,15 --json " +
                small + material)["results"];
    const Json &cf = results[0], &own = results[1];
    BOOST_TEST(cf["stiffness"].is_null());
    BOOST_TEST(cf["kappa"].is_null());
    BOOST_TEST(own["stiffness"] == Json({55, 15, 15}));
    BOOST_TEST(own["status"] == "ok");
    for (const char* measure : {"plate_force", "plate_force_norm", "volume_error",
                                "mean_deviation", "strain_energy"})
      BOOST_TEST(own[measure].get<double>() == cf[measure].get<double>(),
                 boost::test_tools::tolerance(1e-10));
  }
  BOOST_TEST(
      run_springcheck("run compression --method mss-custom --stiffness 55,15,15 "
                      "--kappa 100 --solver semi-implicit --duration .2 --out own.h5 " +
                      small)
          .status == 0);
}

BOOST_AUTO_TEST_CASE(text_and_json_tell_how_springs_differ_from_their_method_s_defaults) {
  const std::string call =
      "run compression --method mss-cf,mss-stvk --spring-strain logarithmic " + small;
  const Json results = json_of(call + " --json")["results"];
  BOOST_TEST(results[0]["method"] == "mss-cf");
  BOOST_TEST(results[0]["variant"] == "mss-cf, logarithmic");
  BOOST_TEST(results[1]["variant"] == "mss-stvk");
  BOOST_TEST(run_springcheck(call).out.find("\nmss-cf, logarithmic ") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_table_shows_the_columns_that_have_values) {
  const std::string affine = run_springcheck("run affine").out,
                    traction = run_springcheck("run traction").out;
  BOOST_TEST(affine.find("affine deviation %") != std::string::npos);
  BOOST_TEST(affine.find("plate force") == std::string::npos);
  BOOST_TEST(traction.find("face z m") != std::string::npos);
  BOOST_TEST(traction.find("tip m") == std::string::npos);
}

// Torque scales with E L^3 and force with E L^2 (static).
BOOST_AUTO_TEST_CASE(results_scale_with_the_units) {
  const auto force = [](const std::string& change) {
    return json_of("run compression --method mss-cf --json " + small +
                   change)["results"][0]["plate_force"]
        .get<double>();
  };
  BOOST_TEST(force("--young 3e4 --size 0.1,0.1,0.1") == 12 * force(""),
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(one_bad_case_exits_3_and_several_methods_are_rows) {
  const std::string wrinkles = "run compression --json --nu 0.25 --deformation 0.2 ";
  const Run one = run_springcheck(wrinkles + "--method mss-nfd --cells 6,6,6");
  BOOST_TEST(one.status == 3);
  const Json json = Json::parse(one.out);
  BOOST_TEST(json["results"][0]["status"] == "wrinkled");
  BOOST_TEST(json["results"][0]["flags"][0] == "wrinkled");
  BOOST_TEST(json["results"][0]["volume_error"].is_number());
  BOOST_TEST(run_springcheck(wrinkles + "--method mss-nfd,mss-cf --cells 6,6,6").status ==
             0);
}

BOOST_AUTO_TEST_CASE(the_exit_status_of_several_methods_is_chosen) {
  const auto status = [](const std::string& methods, const std::string& fail_on) {
    return run_springcheck(
               "run compression --cells 6,6,6 --nu 0.25 --deformation 20% "
               "--method " +
               methods + (fail_on.empty() ? "" : " --fail-on " + fail_on))
        .status;
  };
  const std::string fails = "mss-nfd", works = "mss-cf";  // it wrinkles
  BOOST_TEST(status(fails, "") == 3);
  BOOST_TEST(status(fails, "all") == 3);
  BOOST_TEST(status(fails, "none") == 0);
  for (const std::string& both : {fails + "," + works, works + "," + fails}) {
    BOOST_TEST(status(both, "") == 0);
    BOOST_TEST(status(both, "none") == 0);
    BOOST_TEST(status(both, "all") == 0);
    BOOST_TEST(status(both, "any") == 3);
  }
  BOOST_TEST(status(works, "any") == 0);
  BOOST_TEST(status(fails + "," + works, "diverged,wrinkled") == 3);
  BOOST_TEST(status(fails + "," + works, "diverged,refused") == 0);
  BOOST_TEST(status(fails, "diverged,refused") == 0);
  BOOST_TEST(status(works, "ok") == 3);
}

BOOST_AUTO_TEST_CASE(a_scene_s_expectations_decide_the_exit_status) {
  std::ofstream(folder / "expecting.toml")
      << "test = 'compression'\nsize = [.05, .05, .05]\ncells = [6, 6, 6]\nyoung = 1e4\n"
         "nu = 0.25\ndensity = 1000\ndeformation = '20%'\nmethod = 'mss-nfd'\n"
         "expect = ['wrinkled']\n";
  // TOML wants a digit before the point: shown to the user by line and column.
  expect_bad_input("run expecting.toml", "expecting.toml:2:9: ");
  std::ofstream(folder / "expecting.toml")
      << "test = 'compression'\nsize = [0.05, 0.05, 0.05]\ncells = [6, 6, 6]\nyoung = "
         "1e4\n"
         "nu = 0.25\ndensity = 1000\ndeformation = '20%'\nmethod = 'mss-nfd'\n"
         "expect = ['wrinkled']\n";
  BOOST_TEST(run_springcheck("run expecting.toml").status == 0);
  BOOST_TEST(run_springcheck("run expecting.toml --method mss-cf").status == 3);
}

BOOST_AUTO_TEST_CASE(a_refused_case_has_a_reason_and_null_measures) {
  const Run run = run_springcheck(
      "run compression --method mss-nfd --json --size 0.05,0.05,0.06 " + small);
  BOOST_TEST(run.status == 3);
  const Json result = Json::parse(run.out)["results"][0];
  BOOST_TEST(result["status"] == "refused");
  BOOST_TEST(result["reason"].get<std::string>().find("cubic") != std::string::npos);
  BOOST_TEST(result["volume_error"].is_null());
  const Json baudet = json_of("run compression --method mss-baudet --nu -0.3 --json " +
                              small)["results"][0];
  BOOST_TEST(baudet["status"] == "refused");
}

BOOST_AUTO_TEST_CASE(a_step_above_the_limit_is_refused_unless_forced) {
  const std::string dynamics =
      "run shearing --method mss-cf --solver semi-implicit --duration 0.5 --json " +
      small;
  const Json ok = json_of(dynamics)["results"][0];
  BOOST_TEST(ok["status"] == "ok");
  BOOST_TEST(ok["dt"].get<double>() < ok["dt_limit"].get<double>());
  const Run refused = run_springcheck(dynamics + "--dt 0.1");
  BOOST_TEST(refused.status == 3);
  const Json result = Json::parse(refused.out)["results"][0];
  BOOST_TEST(result["status"] == "refused");
  BOOST_TEST(result["reason"].get<std::string>().find("stability limit") !=
             std::string::npos);
  const Json forced = json_of(dynamics + "--dt 0.01 --force-dt")["results"][0];
  BOOST_TEST(forced["status"] == "diverged");
  BOOST_TEST(forced["volume_error"].is_null());
}

BOOST_AUTO_TEST_CASE(bad_input_exits_2_before_computing) {
  expect_bad_input("run compresion", "expected one of affine, bending");
  expect_bad_input("run nowhere.toml",
                   "nowhere.toml:1:1: expected a readable scene file");
  expect_bad_input("run compression --method mss-fc",
                   "mss-baudet, mss-nfd, mss-fd, mss-cf");
  expect_bad_input("run compression --element q3", "q1, q1-sri, q1-nodal, q2");
  expect_bad_input("run compression --traction 0,0,1", "no traction but in traction");
  expect_bad_input("run compression --gradient 1,0,0,0,0,0,0,0,0",
                   "no gradient but in affine");
  expect_bad_input("run traction --traction 1,0,5", "slides on its plate");
  expect_bad_input("run traction --plates floating", "glued, sliding");
  expect_bad_input("run traction --deformation 0.1", "no deformation in traction");
  expect_bad_input("run affine --gradient -1,0,0,0,0,0,0,0,0", "inside out");
  expect_bad_input("run uniaxial --deformation -1", "above -1");
  expect_bad_input("run compression --lattice cubic",
                   "mss-cf, mss-stvk, mss-hencky, mss-affine");
  expect_bad_input("run compression --method fem-stvk --spring-strain green",
                   "no spring-strain without");
  expect_bad_input("run compression --method mss-cf --directions 16",
                   "no directions without mss-affine");
  expect_bad_input("run compression --lattice-direction 123", "100, 110, 111");
  expect_bad_input("run compression --linear-solver lu",
                   "auto, direct, conjugate-gradients, multigrid");
  expect_bad_input("run compression --method mss-custom",
                   "key 'stiffness': expected KE,KF,KC");
  expect_bad_input("run compression --method mss-custom --stiffness 1,-2,3",
                   "at least 0 N/m, one of them above 0, got [1, -2, 3]");
  expect_bad_input("run compression --stiffness 1,2,3", "no stiffness without");
  expect_bad_input("run compression --kappa -1", "no kappa without mss-custom");
  expect_bad_input("run compression --method mss-custom --stiffness 1,2,3 --split",
                   "whose continuum fem-cauchy-born is");
  expect_bad_input("table 5.1 --reference mss-custom", "constants of its own");
  expect_bad_input("run compression --solver magic",
                   "static, limit, explicit, semi-implicit, verlet, implicit");
  expect_bad_input("run compression --nu 0.5", "--nu: expected a number in (-1, 0.5)");
  expect_bad_input("run compression --young -1", "--young");
  expect_bad_input("run compression --density nan", "--density");
  expect_bad_input("run compression --cells 0,1,1", "--cells");
  expect_bad_input("run compression --cells 5000,5000,5000", "entries");
  expect_bad_input("run compression --reference fem-hooke:q7", "q1, q1-sri");
  expect_bad_input("run compression --dt 0 --solver semi-implicit", "--dt");
  expect_bad_input("run compression --out nowhere/file.h5", "nowhere/file.h5");
  expect_bad_input("run compression --out .", "a directory");
  expect_bad_input("run compression --colour red", "--colour");
  expect_bad_input("table 5.9", "5.1, 5.2");
  expect_bad_input("table 5.1 --format pdf", "md, csv, json");
  expect_bad_input("table 5.1 --from nowhere.h5", "nowhere.h5");
  expect_bad_input("list colours", "methods, scenes");
  expect_bad_input("mesh compression --out mesh.stl", ".msh, .vtu or .inp");
  expect_bad_input("mesh compression --cells 5000,5000,5000 --out m.msh", "GB");
  expect_bad_input("reproduce --out /proc/nowhere", "/proc/nowhere");
  expect_bad_input("reproduce --out ''", "expected a path");
  expect_bad_input("run compression --out ''", "expected a path");
  expect_bad_input("run compression --out x.xdmf", "beside it");
  expect_bad_input("run compression --out /dev/full", "regular file");
  expect_bad_input("run torsion --deformation 5%", "45deg");
  expect_bad_input("run compression --deformation 5deg", "5%");
  expect_bad_input("run tension --deformation 1e200", "at most 100");
  expect_bad_input("run compression --size 1e200,1,1", "1e9 m");
  expect_bad_input("run $(printf 'sc\\377ne.toml')", "UTF-8");
  expect_bad_input("run compression --fixed $(printf 'a\\377')",
                   "argument 4: expected text in UTF-8, got other bytes: 'a?'");
  expect_bad_input("run compression --fail-on some", "one of any, all, none, ok,");
  expect_bad_input("run compression --fail-on wrinkeld", "did you mean 'wrinkled'?");
  expect_bad_input("run compression --fail-on any,ok", "any, all or none alone");
  expect_bad_input("compare",
                   "one of run, table, reproduce, sweep, chart, stability, advise, gate, "
                   "report, export, merge, measure, mesh, schema, list, help");
  expect_bad_input("help rnu", "did you mean 'run'?");
  expect_bad_input("run compression --celltype prism", "did you mean '--cell-type'?");
  expect_bad_input("run", "run: scene is required (see springcheck help run)");
}

// OpenBLAS would ask for its buffer for ever. Whatever the limit, the run ends.
BOOST_AUTO_TEST_CASE(little_address_space_ends_a_run_clearly) {
  for (const int megabytes : {600, 700, 800, 900, 1000}) {
    const Run run =
        run_springcheck("run compression --cells 14,14,14 --method mss-cf --threads 1",
                        "ulimit -v " + std::to_string(megabytes) + "000; timeout 60 ");
    BOOST_TEST((run.status == 0 || run.status == 1 || run.status == 2),
               megabytes << " MB: " << run.status << run.err);
    if (run.status == 1)
      BOOST_TEST(run.err.find("memory is not enough") != std::string::npos, run.err);
    if (run.status == 2) {
      const bool is_told =
          run.err.find("address space (ulimit -v)") != std::string::npos ||
          run.err.find("may still take") != std::string::npos;
      BOOST_TEST(is_told, run.err);
    }
  }
}

// Nor does its thread, which it starts before the program and which asks for one as well,
// keep a program from its end.
BOOST_AUTO_TEST_CASE(little_address_space_ends_every_command) {
  for (const int megabytes : {520, 560, 600, 620, 700})
    for (const char* command :
         {"--version", "list columns", "run compression --cells 2,2,2 --method mss-cf"}) {
      const Run run = run_springcheck(
          command, "ulimit -v " + std::to_string(megabytes) +
                       "000; timeout 60 env --unset=OPENBLAS_NUM_THREADS ");
      BOOST_TEST((run.status == 0 || run.status == 2),
                 megabytes << " MB: " << command << ": " << run.status << run.err);
    }
}

// More than OpenBLAS has places for, of which it wrote behind the last.
BOOST_AUTO_TEST_CASE(many_threads_run_in_a_limited_address_space) {
  const Run run =
      run_springcheck("run compression --cells 2,2,2 --method mss-cf --threads 512",
                      "ulimit -v 80000000; timeout 60 ");
  BOOST_TEST(run.status == 0, run.status << run.err);
}

BOOST_AUTO_TEST_CASE(errors_are_one_line) {
  for (const char* arguments : {"run compression --nu 0.5", "run x.toml", "table 5.9"})
    BOOST_TEST(lines(run_springcheck(arguments).err) == 1U, arguments);
}

BOOST_AUTO_TEST_CASE(without_a_command_it_tells_what_there_is) {
  const Run nothing = run_springcheck("", "COLUMNS=80 "), help = run_springcheck("help"),
            asked = run_springcheck("--help");
  BOOST_TEST(nothing.status == 2);  // nothing was done
  BOOST_TEST(help.status == 0);
  BOOST_TEST(asked.status == 0);
  BOOST_TEST(nothing.out == help.out);
  BOOST_TEST(asked.out == help.out);
  BOOST_TEST(help.out.find("springcheck run compression") != std::string::npos);
  BOOST_TEST(run_springcheck("help", "COLUMNS=50 ").out != help.out);
  for (const char* unusable : {"COLUMNS=0 ", "COLUMNS=1e9 ", "COLUMNS=-50 "})
    BOOST_TEST(run_springcheck("help", unusable).out == nothing.out, unusable);
}

BOOST_AUTO_TEST_CASE(help_version_and_lists_work) {
  for (const char* command :
       {"run", "table", "reproduce", "measure", "list", "mesh", "gate", "manual"}) {
    const std::string name(command);
    BOOST_TEST(run_springcheck(name + " --version").status == 0, name);
    const Run help = run_springcheck(name + " --help");
    BOOST_TEST(help.status == 0, name);
    BOOST_TEST(help.out.starts_with("Usage: springcheck " + name), name);
    BOOST_TEST(run_springcheck("help " + name).out == help.out, name);
  }
  BOOST_TEST(run_springcheck("--version").out.starts_with("springcheck "));
  const Json lists = json_of("list --json");
  for (const char* method : {"mss-baudet", "mss-nfd", "mss-fd", "mss-cf", "mss-custom",
                             "fem-hooke", "fem-stvk", "fem-hencky", "fem-cauchy-born"})
    BOOST_TEST(lists["methods"].contains(method), method);
  for (const char* scene : {"compression", "tension", "shearing", "torsion", "bending",
                            "bending-cm", "uniaxial", "traction", "affine"})
    BOOST_TEST(lists["scenes"].contains(scene), scene);
  for (const char* element : {"q1", "q1-sri", "q1-nodal", "q2"})
    BOOST_TEST(lists["elements"].contains(element), element);
  for (const char* law : {"hooke", "stvk", "hencky", "cauchy-born"})
    BOOST_TEST(lists["materials"].contains(law), law);
  BOOST_TEST(run_springcheck("list elements").out.find("q1-sri") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(what_is_printed_has_a_format) {
  const std::string run = "run compression --cells 2,2,2 --method mss-cf ";
  const Run csv = run_springcheck(run + "--format csv"),
            markdown = run_springcheck(run + "--format md");
  BOOST_TEST(csv.out.starts_with("method,status,volume change %,plate force N,"), csv.out);
  BOOST_TEST(lines(csv.out) == 2U, csv.out);
  const double volume_change = json_of(run + "--json")["results"][0]["volume_change"];
  BOOST_TEST(csv.out.find(fmt::format("mss-cf,ok,{},", 100 * volume_change)) !=
                 std::string::npos,  // all digits
             csv.out);
  BOOST_TEST(markdown.out.find("| mss-cf | ok |") != std::string::npos, markdown.out);
  BOOST_TEST(markdown.out.find("\nDeviations are from ") != std::string::npos);
  BOOST_TEST((json_of(run + "--format json")["results"][0]["volume_change"] ==
              volume_change));
  BOOST_TEST((json_of("list tests --format json") == json_of("list tests --json")));
  const Json quality = json_of("mesh compression --quality --format json");
  BOOST_TEST(quality["rows"][0]["number"] == 1000);
  BOOST_TEST(quality["rows"][0]["histogram"][9] == 1000);
  expect_bad_input("mesh compression --out m.msh --format csv", "--format: expected --quality with it, got none");
  expect_bad_input(run + "--json --format md", "excludes");
}

BOOST_AUTO_TEST_CASE(meshes_are_written_in_three_formats) {
  for (const char* file : {"mesh.msh", "mesh.vtu", "mesh.inp"}) {
    const Run run =
        run_springcheck("mesh bending --cells 2,2,4 --out " + std::string(file));
    BOOST_TEST(run.status == 0, run.err);
    BOOST_TEST(fs::file_size(folder / file) > 0U);
  }
  BOOST_TEST(text_of(folder / "mesh.msh").find("4.1 0 8") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_body_without_free_nodes_is_solved) {
  for (const char* solver : {"static", "semi-implicit --duration 0.1"}) {
    const Json result = json_of(
        "run compression --method mss-cf --cells 1,1,1 --json "
        "--size 0.01,0.01,0.01 --solver " +
        std::string(solver))["results"][0];
    BOOST_TEST(result["status"] == "ok");
    BOOST_TEST(result["dt_limit"].is_null());  // nothing can swing
    BOOST_TEST(result["volume_error"].get<double>() == 0.05,
               boost::test_tools::tolerance(1e-9));
  }
}

// 8 blocks of 512 bytes: less than any result or mesh of this size.
BOOST_AUTO_TEST_CASE(a_full_disk_leaves_the_old_file_alone) {
  for (const char* command :
       {"run compression --method mss-cf --cells 4,4,4 --out", "mesh tension --out"}) {
    const bool is_run = std::string(command).starts_with("run");
    const std::string file = is_run ? "kept.h5" : "kept.msh";
    const std::string arguments = std::string(command) + " " + file;
    BOOST_TEST(run_springcheck(arguments).status == 0);
    const std::string before = text_of(folder / file);
    const auto files = [] {
      return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
    };
    const auto files_before = files();
    const Run run = run_springcheck(arguments, "ulimit -f 8; ");
    BOOST_TEST(run.status == 1, run.err);
    const char* expected = is_run ? "File too large" : "could not be written whole";
    BOOST_TEST(run.err.find(expected) != std::string::npos, run.err);
    BOOST_TEST((text_of(folder / file) == before));
    BOOST_TEST(files() == files_before);  // nothing is left lying about
  }
}

BOOST_AUTO_TEST_CASE(lost_output_is_a_failure) {
  const Run run = run_springcheck("list >/dev/full");
  BOOST_TEST(run.status == 1);
}

BOOST_AUTO_TEST_CASE(a_link_stays_a_link) {
  fs::create_symlink("behind.inp", folder / "link.inp");
  BOOST_TEST(run_springcheck("mesh tension --out link.inp").status == 0);
  BOOST_TEST(fs::is_symlink(folder / "link.inp"));
  BOOST_TEST(fs::file_size(folder / "behind.inp") > 0U);
}

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

// Frequencies of the cube at nu = .25 to the digits of the other tests' oracle, Rayleigh
// and Ritz; that springs differ is what the table is for.
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
