#include "tests/cli/program.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fmt/format.h>

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

// With mu = 2800 Pa and cells of 12.5 mm, k_c = 3 mu h/7 = 15 and k_e = 11/3 k_c = 55
// N/m; kappa = E (4 nu - 1)/(2 (1 + nu)(1 - 2 nu)). Both runs reach a residual of 1e-10.
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
  BOOST_TEST(affine.find("affine deviation [%]") != std::string::npos);
  BOOST_TEST(affine.find("plate force") == std::string::npos);
  BOOST_TEST(traction.find("face z [m]") != std::string::npos);
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

BOOST_AUTO_TEST_CASE(what_is_printed_has_a_format) {
  const std::string run = "run compression --cells 2,2,2 --method mss-cf ";
  const Run csv = run_springcheck(run + "--format csv"),
            markdown = run_springcheck(run + "--format md");
  BOOST_TEST(csv.out.starts_with("method,status,volume change [%],plate force [N],"), csv.out);
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

BOOST_AUTO_TEST_SUITE_END()
