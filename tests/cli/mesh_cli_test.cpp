#include "tests/cli/program.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <sstream>

BOOST_AUTO_TEST_SUITE(mesh_cli_test)

// What the commands say of cell types, quality and meshes of the user's own.

BOOST_AUTO_TEST_CASE(a_case_on_mixed_cells_counts_them_by_type) {
  const Json json = json_of(
      "run compression --cells 3,3,3 --cell-type mixed --distortion 0.2 --method "
      "mss-affine,mss-cf --json");
  const Json& mesh = json["results"][0]["mesh"];
  std::size_t sum = 0;
  for (const auto& [type, count] : mesh["types"].items()) sum += count.get<std::size_t>();
  BOOST_TEST(mesh["types"].size() == 4U);
  BOOST_TEST(mesh["cells"] == sum);
  BOOST_TEST(json["results"][0]["status"] == "ok");
  BOOST_TEST(json["results"][1]["status"] == "refused");
  BOOST_TEST(json["results"][1]["reason"].get<std::string>().find("tetrahedron") !=
             std::string::npos);
}

// The mesh that a case wrote is the mesh that a case reads: nothing but names differs.
BOOST_AUTO_TEST_CASE(a_mesh_that_was_written_gives_the_same_results_when_read) {
  const std::string options =
      " --method mss-affine --nu 0.45 --reference fem-hencky --json";
  BOOST_TEST(run_springcheck("mesh torsion --cells 2,2,2 --cell-type mixed --out own.msh")
                 .status == 0);
  const Json block =
      json_of("run torsion --cells 2,2,2 --cell-type mixed" + options)["results"][0];
  const Json file = json_of("run torsion --mesh own.msh" + options)["results"][0];
  BOOST_TEST(file["mesh"]["sha256"] == block["mesh"]["sha256"]);
  for (const char* name : {"plate_torque", "volume_change", "deviation_l2_relative",
                           "wrinkle_alternation", "wrinkle_amplitude"})
    BOOST_TEST(file[name].get<double>() == block[name].get<double>(),
               boost::test_tools::tolerance(1e-9));  // the centre of the plate, summed
  // The same numbers in millimetres are another body: its lengths are 1000 times smaller,
  // its torques 1e-9 times.
  const Json small =
      json_of("run torsion --mesh own.msh --mesh-unit mm" + options)["results"][0];
  BOOST_TEST(
      small["plate_torque"].get<double>() == 1e-9 * block["plate_torque"].get<double>(),
      boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(quality_is_printed_with_or_without_a_file) {
  const Run run =
      run_springcheck("mesh compression --cells 2,2,2 --cell-type prism --quality");
  BOOST_TEST(run.status == 0);
  BOOST_TEST(run.out.find("16 prisms") != std::string::npos);
  BOOST_TEST(run.out.find("scaled Jacobian") != std::string::npos);
  BOOST_TEST(run.out.find("0.8 to 0.9            16") != std::string::npos, run.out);
  expect_bad_input("mesh compression", "--out: expected a .msh, .vtu or .inp file");
}

BOOST_AUTO_TEST_CASE(meshes_that_cannot_be_used_are_bad_input) {
  run_springcheck("mesh compression --cells 1,1,1 --out good.msh");
  expect_bad_input("run compression --mesh none.msh", "none.msh");
  expect_bad_input("run compression --mesh good.msh --moved lid",
                   "good.msh: moved: unknown surface 'lid', expected one of bottom, top, "
                   "x_max, x_min, y_max, y_min");
  expect_bad_input("run compression --mesh good.msh --fixed botom",
                   "fixed: unknown surface 'botom', did you mean 'bottom'?");
  expect_bad_input("run compression --mesh good.msh --moved ''",
                   "moved: expected the name of a surface, got none");
  expect_bad_input("run good.msh", "expected a scene, and behind it --mesh good.msh");
  expect_bad_input("mesh compression --method mss-cf", "unknown option '--method'");
  const std::string good = text_of(folder / "good.msh");
  std::ofstream(folder / "half.msh") << good.substr(0, good.size() / 2);
  expect_bad_input("run compression --mesh half.msh", "half.msh");
  expect_bad_input("run compression --cell-type cubes", "one of hexahedron");
  expect_bad_input("run compression --cell-type mixed --distortion 3", "Jacobian");
}

// gmsh numbers the surfaces that nobody has named.
BOOST_AUTO_TEST_CASE(surfaces_without_a_name_go_by_their_numbers) {
  run_springcheck("mesh compression --cells 1,1,1 --out named.msh");
  std::string text = text_of(folder / "named.msh");
  const std::string end = "$EndPhysicalNames\n";
  const std::size_t first = text.find("$PhysicalNames"), last = text.find(end);
  BOOST_TEST_REQUIRE(last != std::string::npos);
  const std::string names = text.substr(first, last - first);
  text.erase(first, last + end.size() - first);
  std::ofstream(folder / "numbered.msh") << text;
  const auto number_of = [&](const std::string& name) {
    const std::size_t line = names.rfind('\n', names.find('"' + name + '"'));
    std::istringstream words(names.substr(line + 1));
    int dimension = 0, number = 0;
    words >> dimension >> number;
    return std::to_string(number);
  };
  const std::string run = "run compression --method mss-cf --mesh numbered.msh ";
  expect_bad_input(run,
                   "or the name 'bottom', got 'bottom' (in gmsh, before meshing, "
                   "Physical Surface(\"bottom\") = {...}; gives it)");
  const std::string plates =
      "--fixed " + number_of("bottom") + " --moved " + number_of("top");
  BOOST_TEST(run_springcheck(run + plates).status == 0);
  expect_bad_input(run + "--fixed 0" + number_of("bottom"), "or the name '0");
}

// Van Gelder's springs make no material of a chosen Poisson ratio; the correction moves
// what they do make.
BOOST_AUTO_TEST_CASE(the_correction_of_tetrahedral_springs_can_be_left_out) {
  const std::string run =
      "run shearing --cells 2,2,2 --cell-type tetrahedron --nu 0.4 --method "
      "mss-vangelder --json --correction ";
  const Json with = json_of(run + "on")["results"][0],
             without = json_of(run + "off")["results"][0];
  BOOST_TEST(with["key"] != without["key"]);
  BOOST_TEST(with["plate_force"].get<double>() >
             1.01 * without["plate_force"].get<double>());
  expect_bad_input("run shearing --correction off", "mss-vangelder or mss-lloyd");
}

BOOST_AUTO_TEST_CASE(result_files_hold_mixed_meshes) {
  BOOST_TEST(run_springcheck("run compression --cells 2,2,2 --cell-type mixed --method "
                             "mss-affine --out mixed.h5")
                 .status == 0);
  const std::string xdmf = text_of(folder / "mixed.xdmf");
  BOOST_TEST(xdmf.find("TopologyType=\"Mixed\"") != std::string::npos);
  BOOST_TEST(
      run_springcheck("run compression --cells 2,2,2 --cell-type tetrahedron --method "
                      "mss-affine --out tetrahedra.h5")
          .status == 0);
  BOOST_TEST(text_of(folder / "tetrahedra.xdmf").find("TopologyType=\"Tetrahedron\"") !=
             std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
