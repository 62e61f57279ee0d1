#include "tests/cli/program.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>

BOOST_AUTO_TEST_SUITE(exit_status_cli_test)

namespace {

const std::string small = "--cells 4,4,4 ";

}  // namespace

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
  expect_bad_input("run compression --reference fem-stvk@convergd",
                   "did you mean 'converged'?");
  expect_bad_input("run compression --reference fem-stvk@x",
                   "@NX,NY,NZ, @N or @converged");
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

BOOST_AUTO_TEST_CASE(errors_are_one_line) {
  for (const char* arguments : {"run compression --nu 0.5", "run x.toml", "table 5.9"})
    BOOST_TEST(lines(run_springcheck(arguments).err) == 1U, arguments);
}

BOOST_AUTO_TEST_SUITE_END()
